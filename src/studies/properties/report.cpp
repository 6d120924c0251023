// Builds the report of the study properties from the files of its result folder.
#include <fmt/format.h>

#include "io/csv_table.hpp"
#include "results/report_document.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/properties/run.hpp"

namespace fiberfate {
namespace {

FactsSection asked(const PropertiesCase& values) {
  const CompositeMaterial material = composite_material(values);
  FactsSection section{"asked", "Inputs", {}};
  section.rows = {{"Model", std::string(name(values.solution.model))},
                  {"Closure", values.solution.closure},
                  {"Volume fraction", 100 * material.volume_fraction, "%"},
                  {"Orientation", values.fibers.orientation},
                  {"Young's modulus of the fibers", material.fiber.modulus, "Pa"},
                  {"Poisson's ratio of the fibers", material.fiber.poisson},
                  {"Young's modulus of the matrix", material.matrix.modulus, "Pa"},
                  {"Poisson's ratio of the matrix", material.matrix.poisson}};
  if (values.fibers.aspect_ratio) section.rows.push_back({"Aspect ratio", *values.fibers.aspect_ratio});
  if (values.fibers.length) section.rows.push_back({"Fiber length", *values.fibers.length, "m"});
  if (!values.fibers.distribution.empty())
    section.rows.push_back({"Fiber lengths", fmt::format("{} classes", values.fibers.distribution.size())});
  return section;
}

TableSection constants_table(const SummaryFile& summary) {
  TableSection section{"constants",
                       "Engineering constants",
                       {{"constant"}, {"unit"}, {"of the part"}, {"of aligned fibers"}},
                       {}};
  for (const char* name : {"E_1", "E_2", "E_3", "G_23", "G_31", "G_12"}) {
    const std::string key = std::string(name) + "_Pa";
    section.rows.push_back({std::string(name), std::string("GPa"), 1e-9 * summary.number(key),
                            1e-9 * summary.number("aligned_" + key)});
  }
  for (const char* name : {"nu_23", "nu_31", "nu_12"})
    section.rows.push_back({"ν" + std::string(name).substr(2), std::string(), summary.number(name),
                            summary.number(std::string("aligned_") + name)});
  const Mat3 part = summary.tensor("thermal_expansion_per_K"),
             aligned = summary.tensor("aligned_thermal_expansion_per_K");
  for (int i = 0; i < 3; ++i)
    section.rows.push_back(
        {fmt::format("α_{}", i + 1), std::string("10⁻⁶/K"), 1e6 * part(i, i), 1e6 * aligned(i, i)});
  section.caption =
      "Along axes 1, 2, 3; couplings of shear with stretching are in stiffness_Pa of summary.json.";
  return section;
}

LinesSection modulus_section(const ResultFolder& folder) {
  const CsvTable table = read_csv(folder.file("modulus.csv"));
  LinesSection section{"modulus",         "Young's modulus over direction", {"angle from axis 1", "°"},
                       {"modulus", "Pa"}, table.column("angle_deg"),        {}};
  section.series = {{"towards axis 2", table.column("modulus_12_Pa")},
                    {"towards axis 3", table.column("modulus_13_Pa"), CurveStyle::dashed}};
  return section;
}

}  // namespace

ReportDocument report_properties(const PropertiesCase& values, const ResultFolder& folder) {
  const SummaryFile summary(folder.summary());
  ReportDocument document{"Properties of the part"};
  document.sections.emplace_back(asked(values));
  document.sections.emplace_back(constants_table(summary));
  document.sections.emplace_back(modulus_section(folder));
  return document;
}

}  // namespace fiberfate
