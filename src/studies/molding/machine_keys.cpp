// Describes the keys of the study molding that are about material and machine.
#include "studies/molding/case.hpp"

namespace fiberfate {
namespace {

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

}  // namespace

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
  table.quantity("material.no_flow_temperature", material.no_flow_temperature,
                 {.text = "Temperature below which the melt stands still; 0 K: at none.",
                  .unit = "K",
                  .range = Range::between(0, 2000),
                  .need = Need::usual,
                  .example = "\"403 K\""});
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
  pressure("pressure_limit", machine.pressure_limit,
           "Largest pressure at the sprue; not given: 1 GPa, more than any machine has.");
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
