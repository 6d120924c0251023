// The keys of the study molding that are about gates, valves and what comes in through each gate.
#include <fmt/format.h>

#include <sstream>

#include "base/units.hpp"
#include "studies/molding/case.hpp"

namespace fiberfate {
namespace {

constexpr const char* events_remedy =
    "give start, never, \"filled 0.49\", \"time 2 s\", \"arrival\" or \"sensor S1\", the last two with or "
    "without a delay such as 0.1 s";

/// Reads "start", "never", "filled 0.49", "time 2 s", "arrival", "arrival 0.1 s", "sensor S1" or
/// "sensor S1 0.1 s".
Reading<ValveEvent> read_event(const std::string& text) {
  std::istringstream words(text);
  std::string kind, sensor, amount;
  words >> kind;
  if (kind == "sensor") words >> sensor;
  std::getline(words >> std::ws, amount);
  const auto number = [&amount](const char* unit) {
    return amount.empty() ? 0.0 : quantity_in_si(amount, unit);
  };
  try {
    if (kind == "start" && amount.empty()) return ValveEvent{};
    if (kind == "never" && amount.empty()) return ValveEvent{{TriggerKind::never}, ""};
    if (kind == "filled" && !amount.empty())
      return ValveEvent{{TriggerKind::filled_fraction, number("1")}, ""};
    if (kind == "time" && !amount.empty()) return ValveEvent{{TriggerKind::time, number("s")}, ""};
    if (kind == "arrival") return ValveEvent{{TriggerKind::arrival, number("s")}, ""};
    if (kind == "sensor" && !sensor.empty()) return ValveEvent{{TriggerKind::arrival, number("s")}, sensor};
  } catch (const std::invalid_argument& reason) {
    return Complaint{fmt::format("\"{}\": {}", text, reason.what()), events_remedy};
  }
  return Complaint{fmt::format("\"{}\" is no event", text), events_remedy};
}

std::string write_event(const ValveEvent& event) {
  switch (event.trigger.kind) {
    case TriggerKind::start:
      return "start";
    case TriggerKind::never:
      return "never";
    case TriggerKind::filled_fraction:
      return "filled " + write_number(event.trigger.value);
    case TriggerKind::time:
      return "time " + write_number(event.trigger.value) + " s";
    case TriggerKind::arrival:
      break;
  }
  const std::string where = event.sensor.empty() ? "arrival " : "sensor " + event.sensor + ' ';
  return where + write_number(event.trigger.value) + " s";
}

Reading<ValveTimes> read_valve(const std::vector<TomlValue>& row, const std::vector<ValveTimes>& before) {
  const RowTexts texts(row);
  if (texts.count() < 2) return Complaint{"not a gate with events", ""};
  ValveTimes valve = {texts.text(0), {}};
  for (const ValveTimes& other : before)
    if (other.gate == valve.gate)
      return Complaint{fmt::format("gate \"{}\" has two rows", valve.gate),
                       "give all its events in one row: opens, closes, opens again, ..."};
  for (std::size_t i = 1; i < texts.count(); ++i) {
    const Reading<ValveEvent> reading = read_event(texts.text(i));
    if (const auto* complaint = std::get_if<Complaint>(&reading)) return *complaint;
    valve.events.push_back(std::get<ValveEvent>(reading));
  }
  return valve;
}

std::vector<std::string> write_valve(const ValveTimes& valve, NumberStyle) {
  std::vector<std::string> items = {write_text(valve.gate)};
  for (const ValveEvent& event : valve.events) items.push_back(write_text(write_event(event)));
  return items;
}

KeyRows<GateChoices> place_keys() {
  using Gates = GateChoices;
  const Column resistance = {"", {"Pa s/m^3", "Pa s/m^3"}, Range::between(0, 1e15)};
  return {
      items_key("places", &Gates::places, place_rows(PlaceLines::allowed),
                "Rows [name, x, y] in the flat part or [name, x, y, z] in space; an edge gate has two ends.",
                optional(R"([["G1", "0 mm", "51 mm"]])")),
      key("radius", &Gates::radius, {"m", "mm"}, Range::positive(1), "Radius of these gates."),
      key("resistance", &Gates::resistance, {"Pa s/m^3"}, Range::between(0, 1e15),
          "Resistance R of the runner from the sprue to each gate: p_sprue - p_gate = R Q."),
      items_key(
          "resistances", &Gates::resistances, number_rows("gate", resistance, {"not a gate with numbers"}),
          "Rows [gate, R] of gates whose runner is another one.", optional(R"([["G1", "2e10 Pa s/m^3"]])")),
  };
}

KeyRows<GateChoices> valve_keys() {
  using Gates = GateChoices;
  return {
      items_key("sensors", &Gates::sensors, place_rows(),
                "Places at which the front's arrival is noticed, for gates.valves: rows as those "
                "of places; names of one word.",
                optional(R"([["S1", "150 mm", "51 mm"]])")),
      items_key(
          "valves", &Gates::valves, {read_valve, write_valve},
          "Rows [gate, opens, closes, opens again, ...] of as many events as wanted: \"start\", "
          "\"never\", \"filled 0.49\" (share of the cavity), \"time 2 s\", \"arrival\" or \"arrival 0.1 "
          "s\" (after the front has reached the gate), \"sensor S1\" or \"sensor S1 0.1 s\" (after it has "
          "reached a sensor). Every event waits for the one before it. Other gates are open from the "
          "start.",
          optional(R"([["G1", "filled 0.49", "filled 0.69"], ["G2", "sensor S1", "time 2 s", "time 3 s"]])"),
          "thesis table 14"),
  };
}

KeyRows<GateChoices> inlet_keys() {
  using Gates = GateChoices;
  const auto rows = [](Units units, Range range) {
    return number_rows("gate", {"", std::move(units), range}, {"not a gate with numbers"});
  };
  return {
      items_key("inlet_orientations", &Gates::orientations, rows({"1", "1"}, Range::between(0, 1)),
                "Rows [gate, A11, A22, A33] of gates whose fibers come in with another orientation than "
                "fibers.inlet_orientation, in the same axes.",
                optional(R"([["G1", 0.8, 0.15, 0.05]])")),
      items_key("inlet_lengths", &Gates::lengths, rows({"m", "mm"}, Range::positive(1)),
                "Rows [gate, length, ...] of gates whose fibers come in with other lengths than those of "
                "[fibers]: one length, L_N and L_W, or one a class of the distribution.",
                optional(R"([["G1", "1.5 mm"]])")),
      items_key("inlet_numbers", &Gates::numbers, rows({"1", "1"}, Range::not_negative()),
                "Rows [gate, number, ...] of gates with another distribution: how many fibers are in each "
                "class of fibers.distribution, or in proportion; the volume fraction is that of [fibers].",
                optional(R"([["G1", 120, 60, 4]])")),
  };
}

}  // namespace

KeyGroup<GateChoices> gate_keys() {
  return {"gates", "Where melt enters, besides the gates that belong to the part, and when valves move.",
          joined<GateChoices>({place_keys(), valve_keys(), inlet_keys()})};
}

}  // namespace fiberfate
