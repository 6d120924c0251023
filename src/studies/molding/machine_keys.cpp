// The keys of the study molding that are about material and machine.
#include "studies/molding/case.hpp"

namespace fiberfate {
namespace {

KeyRow<MaterialChoices> preset_key() {
  return {"preset", [](KeyTable& table, const std::string& name, MaterialChoices& material) {
            table.preset(name, material.preset,
                         {.text = "A material that comes with the program, or a file like it "
                                  "(docs/guide/materials.md): its values stand for all keys of [material], "
                                  "[melt], [fibers], [composite], [orientation] and [law] that the case "
                                  "leaves out.",
                          .need = Need::usual,
                          .example = "\"ppgf30\""});
          }};
}

KeyRows<MachineChoices> flow_keys() {
  using Machine = MachineChoices;
  const Column time = {"time", {"s", "s"}, Range::not_negative()};
  const Column share = {"filled", {"1", "1"}, Range::between(0, 1)};
  const Column rate = {"rate", {"m^3/s", "cm^3/s"}, Range::positive(10)};
  const Column speed = {"speed", {"m/s", "mm/s"}, Range::positive(100)};
  const Choices<ProfileForm> forms = {{ProfileForm::steps, "steps", "each row holds until the next"},
                                      {ProfileForm::ramps, "ramps", "linear between the rows"}};
  return {
      key("flow_rate", &Machine::flow_rate, {"m^3/s", "cm^3/s"}, Range::positive(10),
          "Flow rate; give it, or fill_time, or a profile.", usual("\"25 cm^3/s\""),
          "thesis table 13: 616.7 cm^3/s"),
      key("fill_time", &Machine::fill_time, {"s"}, Range::positive(1e4),
          "Time in which the volume of the part comes in at a constant flow rate."),
      rows_key("flow_profile", &Machine::flow_profile, {time, rate},
               "Flow rate over time, rows [time, rate], instead of flow_rate.",
               optional(R"([["0 s", "10 cm^3/s"], ["1 s", "25 cm^3/s"]])")),
      rows_key("flow_by_filled", &Machine::flow_by_filled, {share, rate},
               "Flow rate over the filled share of the cavity, rows [share, rate].",
               optional(R"([[0, "10 cm^3/s"], [0.5, "25 cm^3/s"]])")),
      rows_key("ram_profile", &Machine::ram_profile, {time, speed},
               "Speed of the ram over time, rows [time, speed]; with machine.barrel_diameter.",
               optional(R"([["0 s", "20 mm/s"]])")),
      rows_key("ram_by_filled", &Machine::ram_by_filled, {share, speed},
               "Speed of the ram over the filled share, rows [share, speed].",
               optional(R"([[0, "20 mm/s"]])")),
      key("barrel_diameter", &Machine::barrel_diameter, {"m", "mm"}, Range::positive(1),
          "Diameter of the barrel."),
      key("profile_form", &Machine::profile_form, forms,
          "What happens between the rows of a profile; the last one holds to the end."),
  };
}

KeyRows<MachineChoices> limit_keys() {
  using Machine = MachineChoices;
  const char* table_13 = "thesis table 13";
  return {
      key("switchover", &Machine::switchover, {}, {0, 1, Range::Ends::open_low},
          "Filled share of the cavity at which the machine changes from flow to pressure; 1: never.", {},
          table_13),
      key("switchover_pressure", &Machine::switchover_pressure, {"Pa", "MPa"}, Range::positive(1e10),
          "Pressure at the sprue from then on; not given: what it was at that moment."),
      key("pressure_limit", &Machine::pressure_limit, {"Pa", "MPa"}, Range::positive(1e10),
          "Largest pressure at the sprue; not given: 1 GPa, more than any machine has."),
      key("melt_temperature", &Machine::melt_temperature, {"K"}, Range::between(200, 2000),
          "Temperature of the melt at the gates.", required("\"250 degC\""), table_13),
      key("mold_temperature", &Machine::mold_temperature, {"K"}, Range::between(200, 2000),
          "Temperature of the mold.", required("\"50 degC\""), table_13),
      key("wall_transfer", &Machine::wall_transfer, {"W/(m^2 K)"}, Range::positive(),
          "Heat transfer from melt to mold; not given: the wall has the mold's temperature."),
      key("longest_time", &Machine::longest_time, {"s"}, Range::positive(),
          "Time at which filling stops at the latest."),
  };
}

}  // namespace

KeyGroup<MaterialChoices> material_keys() {
  using Material = MaterialChoices;
  return {"material",
          "The melt with its fibers; the viscosity is in [melt].",
          {
              preset_key(),
              key("density", &Material::density, {"kg/m^3"}, Range::between(100, 1e4), "Density.",
                  required("\"980 kg/m^3\"")),
              key("heat_capacity", &Material::heat_capacity, {"J/(kg K)"}, Range::between(100, 1e4),
                  "Specific heat.", required("\"2200 J/(kg K)\"")),
              key("conductivity", &Material::conductivity, {"W/(m K)"}, Range::between(1e-2, 100),
                  "Thermal conductivity.", required("\"0.24 W/(m K)\"")),
              key("no_flow_temperature", &Material::no_flow_temperature, {"K"}, Range::between(0, 2000),
                  "Temperature below which the melt stands still; 0 K: at none.", usual("\"403 K\"")),
          }};
}

KeyGroup<MachineChoices> machine_keys() {
  return {"machine", "What the injection molding machine does.",
          joined<MachineChoices>({flow_keys(), limit_keys()})};
}

}  // namespace fiberfate
