// Describes the keys of the study molding that are about gates, valves and what comes in through each gate.
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

std::optional<Complaint> append_valve(const std::vector<TomlValue>& row, std::vector<ValveTimes>& valves) {
  const RowTexts texts(row);
  if (texts.count() < 2) return Complaint{"not a gate with events", ""};
  ValveTimes valve = {texts.text(0), {}};
  for (const ValveTimes& other : valves)
    if (other.gate == valve.gate)
      return Complaint{fmt::format("gate \"{}\" has two rows", valve.gate),
                       "give all its events in one row: opens, closes, opens again, ..."};
  for (std::size_t i = 1; i < texts.count(); ++i) {
    const Reading<ValveEvent> reading = read_event(texts.text(i));
    if (const auto* complaint = std::get_if<Complaint>(&reading)) return *complaint;
    valve.events.push_back(std::get<ValveEvent>(reading));
  }
  valves.push_back(std::move(valve));
  return std::nullopt;
}

/// Adds a key of rows [gate, number, …].
void describe_numbers(KeyTable& table, const std::string& key, std::vector<GateNumbers>& gates,
                      const Column& column, KeyNotes notes) {
  const auto append = [&gates, column](const std::vector<TomlValue>& row) -> std::optional<Complaint> {
    if (row.size() < 2) return Complaint{"not a gate with numbers", ""};
    GateNumbers gate = {RowTexts(row).text(0), {}};
    for (const GateNumbers& other : gates)
      if (other.gate == gate.gate)
        return Complaint{fmt::format("gate \"{}\" has two rows", gate.gate), "leave one of them out"};
    for (std::size_t i = 1; i < row.size(); ++i) {
      const Reading<double> reading = read_quantity(row[i], column.units, column.range);
      if (const auto* complaint = std::get_if<Complaint>(&reading)) return *complaint;
      gate.numbers.push_back(std::get<double>(reading));
    }
    gates.push_back(std::move(gate));
    return std::nullopt;
  };
  const auto write = [&gates, column](NumberStyle style) {
    std::vector<std::string> rows;
    for (const GateNumbers& gate : gates) {
      std::vector<std::string> items = {write_text(gate.gate)};
      for (const double number : gate.numbers) items.push_back(write_quantity(number, column.units, style));
      rows.push_back(write_list(items));
    }
    return rows;
  };
  describe_text_rows(table, key, std::move(notes), {append, [&gates] { gates.clear(); }, write});
}

void describe_places_of_gates(KeyTable& table, GateChoices& gates) {
  describe_places(
      table, "gates.places", gates.places, PlaceLines::allowed,
      {.text = "Rows [name, x, y] in the flat part or [name, x, y, z] in space; an edge gate has two ends.",
       .example = R"([["G1", "0 mm", "51 mm"]])"});
  table.quantity(
      "gates.radius", gates.radius,
      {.text = "Radius of these gates.", .unit = "m", .friendly = "mm", .range = Range::positive(1)});
  table.quantity("gates.resistance", gates.resistance,
                 {.text = "Resistance R of the runner from the sprue to each gate: p_sprue - p_gate = R Q.",
                  .unit = "Pa s/m^3",
                  .range = Range::between(0, 1e15)});
  describe_numbers(table, "gates.resistances", gates.resistances,
                   {"resistance", {"Pa s/m^3", "Pa s/m^3"}, Range::between(0, 1e15)},
                   {.text = "Rows [gate, R] of gates whose runner is another one.",
                    .example = R"([["G1", "2e10 Pa s/m^3"]])"});
}

void describe_valves(KeyTable& table, GateChoices& gates) {
  describe_places(table, "gates.sensors", gates.sensors, PlaceLines::no,
                  {.text = "Places at which the front's arrival is noticed, for gates.valves: rows as those "
                           "of places; names of one word.",
                   .example = R"([["S1", "150 mm", "51 mm"]])"});
  describe_text_rows(
      table, "gates.valves",
      {.text =
           "Rows [gate, opens, closes, opens again, ...] of as many events as wanted: \"start\", "
           "\"never\", \"filled 0.49\" (share of the cavity), \"time 2 s\", \"arrival\" or \"arrival 0.1 "
           "s\" (after the front has reached the gate), \"sensor S1\" or \"sensor S1 0.1 s\" (after it has "
           "reached a sensor). Every event waits for the one before it. Other gates are open from the "
           "start.",
       .example = R"([["G1", "filled 0.49", "filled 0.69"], ["G2", "sensor S1", "time 2 s", "time 3 s"]])",
       .source = "thesis table 14"},
      {[&gates](const std::vector<TomlValue>& row) { return append_valve(row, gates.valves); },
       [&gates] { gates.valves.clear(); },
       [&gates](NumberStyle) {
         std::vector<std::string> rows;
         for (const ValveTimes& valve : gates.valves) {
           std::vector<std::string> items = {write_text(valve.gate)};
           for (const ValveEvent& event : valve.events) items.push_back(write_text(write_event(event)));
           rows.push_back(write_list(items));
         }
         return rows;
       }});
}

void describe_inlets(KeyTable& table, GateChoices& gates) {
  describe_numbers(
      table, "gates.inlet_orientations", gates.orientations, {"A", {"1", "1"}, Range::between(0, 1)},
      {.text = "Rows [gate, A11, A22, A33] of gates whose fibers come in with another orientation than "
               "fibers.inlet_orientation, in the same axes.",
       .example = R"([["G1", 0.8, 0.15, 0.05]])"});
  describe_numbers(
      table, "gates.inlet_lengths", gates.lengths, {"length", {"m", "mm"}, Range::positive(1)},
      {.text = "Rows [gate, length, ...] of gates whose fibers come in with other lengths than those of "
               "[fibers]: one length, L_N and L_W, or one a class of the distribution.",
       .example = R"([["G1", "1.5 mm"]])"});
  describe_numbers(
      table, "gates.inlet_numbers", gates.numbers, {"number", {"1", "1"}, Range::not_negative()},
      {.text = "Rows [gate, number, ...] of gates with another distribution: how many fibers are in each "
               "class of fibers.distribution, or in proportion; the volume fraction is that of [fibers].",
       .example = R"([["G1", 120, 60, 4]])"});
}

}  // namespace

void describe_gates(KeyTable& table, GateChoices& gates) {
  table.section("gates",
                "Where melt enters, besides the gates that belong to the part, and when valves move.");
  describe_places_of_gates(table, gates);
  describe_valves(table, gates);
  describe_inlets(table, gates);
}

}  // namespace fiberfate
