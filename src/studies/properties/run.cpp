// Runs the study properties: stiffness, engineering constants and thermal expansion of a part.
#include "studies/properties/run.hpp"

#include <fmt/format.h>

#include "studies/summary_tensors.hpp"

namespace fiberfate {
namespace {

void append_constants(RunSummary& summary, const std::string& prefix,
                      const ThermoelasticProperties& properties) {
  const EngineeringConstants c = engineering_constants(properties.stiffness);
  const std::pair<const char*, double> all[] = {{"E_1_Pa", c.e1},   {"E_2_Pa", c.e2},   {"E_3_Pa", c.e3},
                                                {"G_23_Pa", c.g23}, {"G_31_Pa", c.g31}, {"G_12_Pa", c.g12},
                                                {"nu_23", c.nu23},  {"nu_31", c.nu31},  {"nu_12", c.nu12}};
  for (const auto& [name, value] : all) summary.own.emplace_back(prefix + name, value);
  summary.own.emplace_back(prefix + "thermal_expansion_per_K", thermal_expansion(properties));
  summary.own.emplace_back(prefix + "stiffness_Pa", components(properties.stiffness));
}

}  // namespace

Outcome compute_properties(const PropertiesCase& values, Session&) {
  Outcome outcome;
  RunSummary& summary = outcome.summary;
  const auto [material, aligned, part, modulus] = predict(values);
  summary.volume_fraction = material.volume_fraction;
  summary.orientation = values.fibers.orientation;
  summary.own.emplace_back("model", std::string(name(values.solution.model)));
  append_constants(summary, "", part);
  append_constants(summary, "aligned_", aligned);
  outcome.tables.push_back({"modulus", modulus});
  const EngineeringConstants c = engineering_constants(part.stiffness);
  outcome.headlines.push_back(
      fmt::format("E_1 {:.4g} GPa, E_2 {:.4g} GPa, E_3 {:.4g} GPa", 1e-9 * c.e1, 1e-9 * c.e2, 1e-9 * c.e3));
  return outcome;
}

}  // namespace fiberfate
