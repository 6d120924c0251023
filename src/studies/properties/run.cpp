// Runs the study properties: stiffness, engineering constants and thermal expansion of a part.
#include "studies/properties/run.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/constants.hpp"
#include "io/csv_table.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

constexpr int angle_steps = 72;

void append_constants(RunSummary& summary, const std::string& prefix,
                      const ThermoelasticProperties& properties) {
  const EngineeringConstants c = engineering_constants(properties.stiffness);
  const std::pair<const char*, double> all[] = {{"E_1_Pa", c.e1},   {"E_2_Pa", c.e2},   {"E_3_Pa", c.e3},
                                                {"G_23_Pa", c.g23}, {"G_31_Pa", c.g31}, {"G_12_Pa", c.g12},
                                                {"nu_23", c.nu23},  {"nu_31", c.nu31},  {"nu_12", c.nu12}};
  for (const auto& [name, value] : all) summary.own.emplace_back(prefix + name, value);
  summary.own.emplace_back(prefix + "thermal_expansion_per_K", thermal_expansion(properties));
  std::vector<double> rows;
  for (int i = 0; i < 36; ++i) rows.push_back(properties.stiffness(i / 6, i % 6));
  summary.own.emplace_back(prefix + "stiffness_Pa", rows);
}

/// Young's modulus along n, 1/(nn : S : nn).
double modulus_along(const Mat6& compliance, const Vec3& n) {
  return 1 / double_dot(n * n.transpose(), contracted(compliance, n * n.transpose()));
}

CsvTable modulus_table(const Mat6& stiffness) {
  const Mat6 compliance = inverse(stiffness);
  CsvTable table{{"angle_deg", "modulus_12_Pa", "modulus_13_Pa"}};
  for (int k = 0; k <= angle_steps; ++k) {
    const double angle = pi * k / angle_steps;
    table.append({180.0 * k / angle_steps, modulus_along(compliance, {std::cos(angle), std::sin(angle), 0}),
                  modulus_along(compliance, {std::cos(angle), 0, std::sin(angle)})});
  }
  return table;
}

}  // namespace

Outcome compute_properties(const PropertiesCase& values, Session& session) {
  Outcome outcome;
  RunSummary& summary = outcome.summary;
  const CompositeMaterial material = composite_material(values);
  const Mat3& second = values.fibers.orientation;
  const ThermoelasticProperties aligned =
      length_average(material, aspect_ratios(values.fibers), values.solution.model);
  const ThermoelasticProperties part =
      orientation_average(aligned, close(second, closure_named(values.solution.closure)), second);
  summary.volume_fraction = material.volume_fraction;
  summary.orientation = second;
  summary.own.emplace_back("model", std::string(name(values.solution.model)));
  append_constants(summary, "", part);
  append_constants(summary, "aligned_", aligned);
  outcome.tables.push_back({"modulus", modulus_table(part.stiffness)});
  const EngineeringConstants c = engineering_constants(part.stiffness);
  session.recorder().note(
      fmt::format("E_1 {:.4g} GPa, E_2 {:.4g} GPa, E_3 {:.4g} GPa", 1e-9 * c.e1, 1e-9 * c.e2, 1e-9 * c.e3));
  return outcome;
}

}  // namespace fiberfate
