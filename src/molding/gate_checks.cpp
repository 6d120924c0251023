// Compares gates with the part and their events with each other.
#include "molding/gate_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "molding/gate_nodes.hpp"

namespace fiberfate {
namespace {

/// A sensor may lie so far off the middle surface, m.
constexpr double sensor_reach = 1e-3;

/// A problem of one gate or sensor: its value is the name.
InputProblem problem_of(const std::string& name, const char* key, std::string complaint, std::string remedy) {
  return {"", 0, 0, key, name, std::move(complaint), std::move(remedy)};
}

/// Writes an event as case files do.
std::string text_of(const Trigger& trigger, const std::vector<Sensor>& sensors) {
  const std::string at = trigger.sensor >= 0 && trigger.sensor < std::ssize(sensors)
                             ? " at " + sensors[trigger.sensor].name
                             : "";
  switch (trigger.kind) {
    case TriggerKind::start:
      return "start";
    case TriggerKind::filled_fraction:
      return fmt::format("filled {:g}", trigger.value);
    case TriggerKind::time:
      return fmt::format("time {:g} s", trigger.value);
    case TriggerKind::arrival:
      return fmt::format("arrival{} {:g} s", at, trigger.value);
    case TriggerKind::never:
      break;
  }
  return "never";
}

/// Whether two events wait for the same clock, so that their values must rise.
bool comparable(const Trigger& first, const Trigger& second) {
  if (first.kind == TriggerKind::start)
    return second.kind == TriggerKind::time || second.kind == TriggerKind::filled_fraction;
  return first.kind == second.kind && (first.kind != TriggerKind::arrival || first.sensor == second.sensor) &&
         first.kind != TriggerKind::never;
}

class EventChecker {
 public:
  EventChecker(const Gate& gate, const std::vector<Sensor>& sensors, std::vector<InputProblem>& problems)
      : sensors_(sensors), problems_(problems), gate_(gate.name) {
    for (const OpenInterval& interval : gate.intervals) {
      events_.push_back(interval.opens);
      events_.push_back(interval.closes);
    }
  }

  void check() {
    for (std::size_t i = 0; i < events_.size(); ++i) {
      check_value(events_[i]);
      if (i > 0) check_order(i);
    }
  }

 private:
  void add(std::string complaint, std::string remedy) {
    problems_.push_back(problem_of(gate_, "gates.events", std::move(complaint), std::move(remedy)));
  }

  void check_value(const Trigger& event) {
    const bool share = event.kind == TriggerKind::filled_fraction;
    if (!(event.value >= 0) || (share && event.value > 1))
      add(text_of(event, sensors_) + " is out of range",
          share ? "give a filled share in 0 to 1" : "give a time or delay of at least 0 s");
    if (event.sensor != own_gate && (event.sensor < 0 || event.sensor >= std::ssize(sensors_)))
      add(fmt::format("there is no sensor number {}", event.sensor), "place the sensor first");
  }

  void check_order(std::size_t i) {
    const Trigger& event = events_[i];
    const std::string text = fmt::format("event {}, {},", i + 1, text_of(event, sensors_));
    if (event.kind == TriggerKind::start)
      add(text + " comes after another event", "let only the first event be start");
    if (events_[i - 1].kind == TriggerKind::never && event.kind != TriggerKind::never)
      add(text + " follows one that never comes", "let only the last event be never");
    for (std::size_t before = 0; before < i; ++before)
      if (comparable(events_[before], event) && !(event.value > events_[before].value)) {
        add(fmt::format("{} does not come after event {}, {}", text, before + 1,
                        text_of(events_[before], sensors_)),
            "sort the events: opens, closes, opens again, ...");
        return;
      }
  }

  const std::vector<Sensor>& sensors_;
  std::vector<InputProblem>& problems_;
  const std::string& gate_;
  std::vector<Trigger> events_;
};

InputProblem off_the_part(const std::string& name, const char* key, double gap) {
  return problem_of(name, key, fmt::format("it lies {:.4g} mm off the part", 1e3 * gap),
                    "move it onto the middle surface of the part");
}

bool opens_at_start(const Gate& gate) {
  if (gate.intervals.empty()) return false;
  const Trigger& first = gate.intervals.front().opens;
  return first.kind == TriggerKind::start ||
         (first.value == 0 &&
          (first.kind == TriggerKind::filled_fraction || first.kind == TriggerKind::time));
}

}  // namespace

void check_gates(const FillingParams& params, const ShellMesh& mesh, std::vector<InputProblem>& problems) {
  bool some_open = false;
  for (const Gate& gate : params.gates) {
    if (!(gate.radius > 0) || !std::isfinite(gate.radius))
      problems.push_back(problem_of(gate.name, "gates.radius",
                                    fmt::format("{:g} m is not positive", gate.radius),
                                    "give a number above zero"));
    if (!(gate.resistance >= 0) || !std::isfinite(gate.resistance))
      problems.push_back(problem_of(gate.name, "gates.resistance",
                                    fmt::format("{:g} Pa s/m3 is negative or not finite", gate.resistance),
                                    "give 0 for no runner"));
    EventChecker(gate, params.sensors, problems).check();
    some_open = some_open || opens_at_start(gate);
    if (const double gap = distance_from_part(gate, mesh); gap > gate.radius)
      problems.push_back(off_the_part(gate.name, "gates.position", gap));
  }
  for (const Sensor& sensor : params.sensors) {
    Gate probe;
    probe.position = sensor.position;
    if (const double gap = distance_from_part(probe, mesh); gap > sensor_reach)
      problems.push_back(off_the_part(sensor.name, "sensors.position", gap));
  }
  if (params.gates.empty())
    problems.push_back({"", 0, 0, "gates", "", "there are none", "place at least one gate on the part"});
  else if (!some_open)
    problems.push_back({"", 0, 0, "gates", "", "none is open at the start: the cavity cannot fill",
                        "let at least one gate open at the start"});
}

}  // namespace fiberfate
