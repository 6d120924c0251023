// Describes the keys of the study molding that are about gates, material and machine.
#include <fmt/format.h>

#include <sstream>

#include "app/studies/molding_case.hpp"
#include "base/units.hpp"

namespace fiberfate {
namespace {

/// Reads "start", "never", "filled 0.49", "time 2 s", "arrival" or "arrival 0.1 s".
Reading<Trigger> read_trigger(const std::string& text) {
  std::istringstream words(text);
  std::string kind, amount;
  words >> kind;
  std::getline(words >> std::ws, amount);
  const auto number = [&amount](const char* unit) {
    return amount.empty() ? 0.0 : quantity_in_si(amount, unit);
  };
  try {
    if (kind == "start" && amount.empty()) return Trigger{};
    if (kind == "never" && amount.empty()) return Trigger{TriggerKind::never, 0, {}};
    if (kind == "filled" && !amount.empty()) return Trigger{TriggerKind::filled_fraction, number("1"), {}};
    if (kind == "time" && !amount.empty()) return Trigger{TriggerKind::time, number("s"), {}};
    if (kind == "arrival") return Trigger{TriggerKind::arrival, number("s"), {}};
  } catch (const std::invalid_argument& reason) {
    return Complaint{fmt::format("\"{}\": {}", text, reason.what()), ""};
  }
  return Complaint{fmt::format("\"{}\" is no event", text),
                   "give start, never, \"filled 0.49\", \"time 2 s\", or arrival with or without a delay"};
}

std::string write_trigger(const Trigger& trigger) {
  switch (trigger.kind) {
    case TriggerKind::start:
      return "start";
    case TriggerKind::never:
      return "never";
    case TriggerKind::filled_fraction:
      return "filled " + write_number(trigger.value);
    case TriggerKind::time:
      return "time " + write_number(trigger.value) + " s";
    case TriggerKind::arrival:
      break;
  }
  return "arrival " + write_number(trigger.value) + " s";
}

std::optional<Complaint> append_valve(const std::vector<TomlValue>& row, std::vector<ValveTimes>& valves) {
  const RowTexts texts(row);
  if (texts.count() < 2 || texts.count() > 3) return Complaint{"not a gate with one or two events", ""};
  ValveTimes valve;
  valve.gate = texts.text(0);
  for (std::size_t i = 1; i < texts.count(); ++i) {
    const Reading<Trigger> reading = read_trigger(texts.text(i));
    if (const auto* complaint = std::get_if<Complaint>(&reading)) return *complaint;
    (i == 1 ? valve.opens : valve.closes) = std::get<Trigger>(reading);
  }
  valves.push_back(valve);
  return std::nullopt;
}

void describe_profiles(KeyTable& table, MachineChoices& machine) {
  const Column time = {"time", {"s", "s"}, Range::not_negative()};
  const Column share = {"filled", {"1", "1"}, Range::between(0, 1)};
  const Column rate = {"rate", {"m^3/s", "cm^3/s"}, Range::positive(10)};
  const Column speed = {"speed", {"m/s", "mm/s"}, Range::positive(100)};
  table.rows("machine.flow_profile", machine.flow_profile, {time, rate},
             {.text = "Flow rate over time, rows [time, rate], instead of flow_rate.",
              .example = R"([["0 s", "10 cm^3/s"], ["1 s", "25 cm^3/s"]])"});
  table.rows("machine.flow_by_filled", machine.flow_by_filled, {share, rate},
             {.text = "Flow rate over the filled share of the cavity, rows [share, rate].",
              .example = R"([[0, "10 cm^3/s"], [0.5, "25 cm^3/s"]])"});
  table.rows("machine.ram_profile", machine.ram_profile, {time, speed},
             {.text = "Speed of the ram over time, rows [time, speed]; with machine.barrel_diameter.",
              .example = R"([["0 s", "20 mm/s"]])"});
  table.rows("machine.ram_by_filled", machine.ram_by_filled, {share, speed},
             {.text = "Speed of the ram over the filled share, rows [share, speed].",
              .example = R"([[0, "20 mm/s"]])"});
  table.quantity(
      "machine.barrel_diameter", machine.barrel_diameter,
      {.text = "Diameter of the barrel.", .unit = "m", .friendly = "mm", .range = Range::positive(1)});
  table.choice("machine.profile_form", machine.profile_form,
               {{ProfileForm::steps, "steps", "each row holds until the next"},
                {ProfileForm::ramps, "ramps", "linear between the rows"}},
               {.text = "What happens between the rows of a profile; the last one holds to the end."});
}

/// Adds a key of rows [gate, number, …].
void describe_inlets(KeyTable& table, const std::string& key, std::vector<GateInlet>& inlets,
                     const Units& units, const Range& range, KeyNotes notes) {
  const auto append = [&inlets, units, range](const std::vector<TomlValue>& row) -> std::optional<Complaint> {
    if (row.size() < 2) return Complaint{"not a gate with numbers", ""};
    GateInlet inlet = {RowTexts(row).text(0), {}};
    for (std::size_t i = 1; i < row.size(); ++i) {
      const Reading<double> reading = read_quantity(row[i], units, range);
      if (const auto* complaint = std::get_if<Complaint>(&reading)) return *complaint;
      inlet.numbers.push_back(std::get<double>(reading));
    }
    inlets.push_back(std::move(inlet));
    return std::nullopt;
  };
  const auto write = [&inlets, units](NumberStyle style) {
    std::vector<std::string> rows;
    for (const GateInlet& inlet : inlets) {
      std::vector<std::string> items = {write_text(inlet.gate)};
      for (const double number : inlet.numbers) items.push_back(write_quantity(number, units, style));
      rows.push_back(write_list(items));
    }
    return rows;
  };
  describe_text_rows(table, key, std::move(notes), {append, [&inlets] { inlets.clear(); }, write});
}

}  // namespace

void describe_gates(KeyTable& table, GateChoices& gates) {
  table.section("gates",
                "Where melt enters, besides the gates that belong to the part, and when valves move.");
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
  describe_text_rows(
      table, "gates.valves",
      {.text =
           "Rows [gate, opens, closes] with the events \"start\", \"never\", \"filled 0.49\" (share of the "
           "cavity), \"time 2 s\", \"arrival\" or \"arrival 0.1 s\" (after the front has reached the gate). "
           "Other "
           "gates are open from the start.",
       .example = R"([["G1", "filled 0.49", "filled 0.69"]])",
       .source = "thesis table 14"},
      {[&gates](const std::vector<TomlValue>& row) { return append_valve(row, gates.valves); },
       [&gates] { gates.valves.clear(); },
       [&gates](NumberStyle) {
         std::vector<std::string> rows;
         for (const ValveTimes& valve : gates.valves)
           rows.push_back(write_list({write_text(valve.gate), write_text(write_trigger(valve.opens)),
                                      write_text(write_trigger(valve.closes))}));
         return rows;
       }});
  describe_inlets(
      table, "gates.inlet_orientations", gates.orientations, {"1", "1"}, Range::between(0, 1),
      {.text = "Rows [gate, A11, A22, A33] of gates whose fibers come in with another orientation than "
               "fibers.inlet_orientation, in the same axes.",
       .example = R"([["G1", 0.8, 0.15, 0.05]])"});
  describe_inlets(
      table, "gates.inlet_lengths", gates.lengths, {"m", "mm"}, Range::positive(1),
      {.text = "Rows [gate, length, ...] of gates whose fibers come in with other lengths than those of "
               "[fibers]: one length, L_N and L_W, or one a class of the distribution.",
       .example = R"([["G1", "1.5 mm"]])"});
}

void describe_material(KeyTable& table, MaterialChoices& material) {
  table.section("material", "The melt with its fibers; the viscosity is in [melt].");
  const auto property = [&table](const char* key, double& member, const char* unit, Range range,
                                 const char* text, const char* example) {
    table.quantity(std::string("material.") + key, member,
                   {.text = text, .unit = unit, .range = range, .need = Need::required, .example = example});
  };
  table.preset(
      "material.preset", material.preset,
      {.text =
           "A material that comes with the program, or a file like it (docs/guide/materials.md): its values "
           "stand for all keys of [material], [melt], [fibers], [composite], [orientation] and [law] that "
           "the case leaves out.",
       .need = Need::usual,
       .example = "\"ppgf30\""});
  property("density", material.density, "kg/m^3", Range::between(100, 1e4), "Density.", "\"980 kg/m^3\"");
  property("heat_capacity", material.heat_capacity, "J/(kg K)", Range::between(100, 1e4), "Specific heat.",
           "\"2200 J/(kg K)\"");
  property("conductivity", material.conductivity, "W/(m K)", Range::between(1e-2, 100),
           "Thermal conductivity.", "\"0.24 W/(m K)\"");
  property("no_flow_temperature", material.no_flow_temperature, "K", Range::between(0, 2000),
           "Temperature below which the melt stands still.", "\"403 K\"");
}

void describe_machine(KeyTable& table, MachineChoices& machine) {
  table.section("machine", "What the injection molding machine does.");
  table.quantity("machine.flow_rate", machine.flow_rate,
                 {.text = "Flow rate; give it, or fill_time, or a profile.",
                  .unit = "m^3/s",
                  .friendly = "cm^3/s",
                  .range = Range::positive(10),
                  .need = Need::usual,
                  .example = "\"25 cm^3/s\"",
                  .source = "thesis table 13: 616.7 cm^3/s"});
  table.quantity("machine.fill_time", machine.fill_time,
                 {.text = "Time in which the volume of the part comes in at a constant flow rate.",
                  .unit = "s",
                  .range = Range::positive(1e4)});
  describe_profiles(table, machine);
  table.quantity(
      "machine.switchover", machine.switchover,
      {.text = "Filled share of the cavity at which the machine changes from flow to pressure; 1: never.",
       .range = Range{0, 1, Range::Ends::open_low},
       .source = "thesis table 13"});
  const auto pressure = [&table](const char* key, std::optional<double>& member, const char* text) {
    table.quantity(std::string("machine.") + key, member,
                   {.text = text, .unit = "Pa", .friendly = "MPa", .range = Range::positive(1e10)});
  };
  pressure("switchover_pressure", machine.switchover_pressure,
           "Pressure at the sprue from then on; not given: what it was at that moment.");
  pressure("pressure_limit", machine.pressure_limit, "Largest pressure at the sprue; not given: none.");
  const auto temperature = [&table](const char* key, double& member, const char* text, const char* example) {
    table.quantity(std::string("machine.") + key, member,
                   {.text = text,
                    .unit = "K",
                    .range = Range::between(200, 2000),
                    .need = Need::required,
                    .example = example,
                    .source = "thesis table 13"});
  };
  temperature("melt_temperature", machine.melt_temperature, "Temperature of the melt at the gates.",
              "\"523.15 K\"");
  temperature("mold_temperature", machine.mold_temperature, "Temperature of the mold.", "\"323.15 K\"");
  table.quantity("machine.wall_transfer", machine.wall_transfer,
                 {.text = "Heat transfer from melt to mold; not given: the wall has the mold's temperature.",
                  .unit = "W/(m^2 K)",
                  .range = Range::positive()});
  table.quantity(
      "machine.longest_time", machine.longest_time,
      {.text = "Time at which filling stops at the latest.", .unit = "s", .range = Range::positive()});
}

}  // namespace fiberfate
