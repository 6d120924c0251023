// The report of the study molding from the files of its result folder.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "base/constants.hpp"
#include "io/csv_table.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/law_facts.hpp"
#include "studies/molding/gates.hpp"
#include "studies/molding/observables.hpp"
#include "studies/molding/part_section.hpp"
#include "studies/molding/run.hpp"
#include "studies/molding/sections.hpp"

namespace fiberfate {
namespace {

/// In the order of PartKind.
constexpr const char* part_names[] = {"from a file", "plaque", "disc", "frame", "ribbed plate", "tailgate"};

FactsSection asked(const MoldingCase& values) {
  FactsSection section{"asked", "Inputs", {}};
  section.rows = {
      {"Part", std::string(part_names[static_cast<std::size_t>(values.part.kind)])},
      values.part.thickness ? Fact{"Thickness", *values.part.thickness, "m"}
                            : Fact{"Thickness", std::string("by element")},
      {"Melt", values.machine.melt_temperature - zero_celsius, "degC"},
      {"Mold", values.machine.mold_temperature - zero_celsius, "degC"},
      {"Fiber volume fraction", values.fibers.volume_fraction},
      {"Coupling",
       std::string(values.fibers.coupling == CouplingChoice::none ? "none" : "informed isotropic")}};
  if (values.fibers.length) section.rows.push_back({"Length at the gates", *values.fibers.length, "m"});
  append(section.rows, law_facts(viscosity_menu(), "Viscosity", values.melt));
  append(section.rows, law_facts(orientation_menu(), "Orientation", values.orientation));
  append(section.rows, law_facts(attrition_menu(), "Length", values.law));
  append(section.rows, law_facts(attrition_menu(), "Compared with", values.compared));
  return section;
}

FactsSection came_out(const SummaryFile& summary) {
  FactsSection section{"outcome", "Results", {}};
  section.rows = {
      {"End", summary.text("filling_end")},
      {"Filled share of the cavity", 100 * summary.number("filled_fraction"), "%"},
      {"Time", summary.number("simulated_s"), "s"},
      {"Greatest pressure at the sprue", summary.number("greatest_sprue_pressure_Pa"), "Pa"},
      {"Volume of the part", 1e6 * summary.number("volume_m3"), "cm^3"},
      {"L_N of the part", summary.number("L_N_m"), "m"},
      {"L_W of the part", summary.number("L_W_m"), "m"},
      {"Orientation tensor of the part", summary.tensor("A2"), "", "in the axes of the part"},
      {"Error of the volume balance", summary.number("volume_error"), "", "over the volume of the part"},
      {"Error of the heat balance", summary.number("heat_error"), "", "over the heat that came in"}};
  return section;
}

FactsSection effort(const SummaryFile& summary) {
  return {"effort",
          "Effort",
          {{"Nodes", summary.count("nodes")},
           {"Triangles", summary.count("triangles")},
           {"Steps", summary.count("steps")},
           {"Threads", summary.count("threads")},
           {"Wall time", summary.number("wall_s"), "s"},
           {"Pressure", summary.number("filling_flow_s"), "s"},
           {"Front", summary.number("filling_front_s"), "s"},
           {"Heat", summary.number("filling_heat_s"), "s"},
           {"Lengths", summary.number("filling_lengths_s"), "s"},
           {"Orientation", summary.number("filling_orientation_s"), "s"},
           {"Peak memory", summary.number("peak_memory_bytes") / 1048576, "MiB"}}};
}

/// Draws pressures, flow rates and the filled share over time.
void add_charts(const MoldingCase& values, const CsvTable& series, std::vector<ReportSection>& sections) {
  const std::vector<Gate> gates = gates_of(values.gates, part_around(values.part));
  for (LinesSection& chart : draw(filling_charts(), filling_observables(gates), series)) {
    if (chart.id == "pressure")
      chart.caption =
          "In the step that brings in the last melt, pressures grow no faster than the volume: the few "
          "places "
          "that are free at last have no front of their own.";
    if (chart.y.unit == "m3/s") {
      chart.y.unit = "cm^3/s";
      for (ReportSeries& curve : chart.series)
        for (double& rate : curve.values) rate *= 1e6;
    }
    sections.emplace_back(std::move(chart));
  }
}

void add_tables(const MoldingCase& values, const ResultFolder& folder, const SummaryFile& summary,
                std::vector<ReportSection>& sections) {
  const auto is_there = [&folder](const char* name) { return std::filesystem::exists(folder.file(name)); };
  const auto table = [&](const char* name) {
    return is_there(name) ? read_csv(folder.file(name)) : CsvTable{};
  };
  CsvTable places;
  if (is_there("places.csv"))
    places = read_numbered(folder.file("places.csv"), {"place", values.output.places.size()});
  if (places.rows() > 0) sections.emplace_back(places_section(values, places));
  if (const CsvTable profiles = table("profiles.csv"); profiles.rows() > 0)
    append(sections, profile_sections(values, profiles));
  if (const CsvTable histogram = table("histogram.csv"); histogram.rows() > 0)
    sections.emplace_back(molding_histogram(values, histogram));
  if (const CsvTable sweep = table("sweep.csv"); sweep.rows() > 0) {
    sections.emplace_back(sweep_section(values, sweep));
    if (places.rows() > 0) sections.emplace_back(measured_section(values, places, summary));
  }
}

}  // namespace

ReportDocument report_molding(const MoldingCase& values, const ResultFolder& folder) {
  ReportDocument document{"Mold filling"};
  document.sections.emplace_back(asked(values));
  const std::optional<SummaryFile> summary = read_summary(folder.summary());
  if (summary) document.sections.emplace_back(came_out(*summary));
  document.sections.emplace_back(part_section(values, folder));
  add_charts(values, read_csv(folder.series()), document.sections);
  // The summary is written last: without it, tables may lack.
  if (summary) add_tables(values, folder, *summary, document.sections);
  if (summary) document.sections.emplace_back(effort(*summary));
  return document;
}

}  // namespace fiberfate
