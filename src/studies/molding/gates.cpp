// Translates [gates].
#include "studies/molding/gates.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace fiberfate {
namespace {

/// Raises InputError; its value is the name with which the faulty row of the key begins.
[[noreturn]] void refuse(const char* key, const std::string& row, std::string complaint, std::string remedy) {
  throw InputError({{"", 0, 0, key, row, std::move(complaint), std::move(remedy)}});
}

/// Finds a gate by name; raises InputError with the key that names it.
std::size_t gate_named(const std::vector<Gate>& gates, const std::string& wanted, const char* key) {
  for (std::size_t i = 0; i < gates.size(); ++i)
    if (gates[i].name == wanted) return i;
  refuse(key, wanted, fmt::format("there is no gate \"{}\"", wanted),
         "name a gate of [gates] places or of the part; a part's only gate is called \"gate\"");
}

Trigger trigger_of(const ValveEvent& event, const std::string& gate, const std::vector<NamedPlace>& sensors) {
  Trigger trigger = event.trigger;
  if (event.sensor.empty()) return trigger;
  const auto found = std::find_if(sensors.begin(), sensors.end(),
                                  [&](const NamedPlace& one) { return one.name == event.sensor; });
  if (found == sensors.end())
    refuse("gates.valves", gate, fmt::format("there is no sensor \"{}\"", event.sensor),
           "place it in gates.sensors");
  trigger.sensor = static_cast<int>(found - sensors.begin());
  return trigger;
}

/// Pairs events to intervals: opens, closes, opens, ...
std::vector<OpenInterval> intervals_of(const ValveTimes& valve, const std::vector<NamedPlace>& sensors) {
  std::vector<OpenInterval> intervals;
  for (std::size_t i = 0; i < valve.events.size(); ++i) {
    const Trigger trigger = trigger_of(valve.events[i], valve.gate, sensors);
    if (i % 2 == 0)
      intervals.push_back({trigger});
    else
      intervals.back().closes = trigger;
  }
  return intervals;
}

Gate gate_at(const NamedPlace& place, double radius, const MoldingPart& part) {
  Gate gate;
  gate.name = place.name;
  gate.radius = radius;
  const auto half = static_cast<std::ptrdiff_t>(place.numbers.size() / 2);
  const bool line = place.numbers.size() > 3;
  const auto begin = place.numbers.begin(), middle = line ? begin + half : place.numbers.end();
  gate.position = position_of({place.name, {begin, middle}}, part);
  if (line) gate.end = position_of({place.name, {middle, place.numbers.end()}}, part);
  return gate;
}

void require_numbers(const NamedNumbers& gate, std::size_t wanted, const char* key, const char* remedy) {
  if (gate.numbers.size() != wanted)
    refuse(key, gate.name,
           fmt::format("gate \"{}\" has {} numbers where {} belong", gate.name, gate.numbers.size(), wanted),
           remedy);
}

}  // namespace

std::vector<Sensor> sensors_of(const GateChoices& choices, const MoldingPart& part) {
  std::vector<Sensor> sensors;
  for (const NamedPlace& place : choices.sensors) {
    if (place.name.empty() || place.name.find(' ') != std::string::npos)
      refuse("gates.sensors", place.name, fmt::format("\"{}\" is not one word", place.name),
             "events name sensors by one word, as in \"sensor S1 0.1 s\"");
    sensors.push_back({place.name, position_of(place, part)});
  }
  return sensors;
}

std::vector<Gate> gates_of(const GateChoices& choices, const MoldingPart& part) {
  std::vector<Gate> gates = part.gates;
  for (const NamedPlace& place : choices.places) gates.push_back(gate_at(place, choices.radius, part));
  for (Gate& gate : gates) gate.resistance = choices.resistance;
  for (const NamedNumbers& one : choices.resistances) {
    require_numbers(one, 1, "gates.resistances", "give one resistance");
    gates[gate_named(gates, one.name, "gates.resistances")].resistance = one.numbers[0];
  }
  for (const ValveTimes& valve : choices.valves)
    gates[gate_named(gates, valve.gate, "gates.valves")].intervals = intervals_of(valve, choices.sensors);
  return gates;
}

void add_gate_inlets(const GateChoices& choices, MoldingSetup& setup) {
  MoldingFibers& fibers = setup.params.fibers;
  if (choices.orientations.empty() && choices.lengths.empty() && choices.numbers.empty()) return;
  fibers.gate_inlets.assign(setup.params.gates.size(), std::nullopt);
  const auto inlet_of = [&](const std::string& gate, const char* key) -> InletFibers& {
    std::optional<InletFibers>& inlet = fibers.gate_inlets[gate_named(setup.params.gates, gate, key)];
    if (!inlet) inlet = fibers.inlet;
    return *inlet;
  };
  for (const NamedNumbers& one : choices.orientations) {
    require_numbers(one, 3, "gates.inlet_orientations", "give A11, A22 and A33");
    inlet_of(one.name, "gates.inlet_orientations").orientation =
        Vec3(one.numbers[0], one.numbers[1], one.numbers[2]).asDiagonal();
  }
  const std::size_t classes = fibers.class_lengths.size();
  for (const NamedNumbers& one : choices.lengths) {
    require_numbers(one, classes, "gates.inlet_lengths", "give one length a class of [fibers]");
    inlet_of(one.name, "gates.inlet_lengths").lengths = one.numbers;
  }
  for (const NamedNumbers& one : choices.numbers) {
    if (setup.reading == LengthReading::means || classes < 2)
      refuse("gates.inlet_numbers", one.name, "there is no distribution whose classes could be counted",
             "give fibers.distribution");
    require_numbers(one, classes, "gates.inlet_numbers", "give one number a class of fibers.distribution");
    inlet_of(one.name, "gates.inlet_numbers").numbers = one.numbers;
  }
}

}  // namespace fiberfate
