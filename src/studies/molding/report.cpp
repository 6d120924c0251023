// Builds the report of the study molding from the files of its result folder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/csv_table.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/law_facts.hpp"
#include "studies/molding/run.hpp"
#include "studies/molding/sections.hpp"

namespace fiberfate {
namespace {

const char* part_name(PartKind kind) {
  switch (kind) {
    case PartKind::file:
      return "from a file";
    case PartKind::plaque:
      return "plaque";
    case PartKind::disc:
      return "disc";
    case PartKind::frame:
      return "frame";
    case PartKind::ribbed:
      return "ribbed plate";
    case PartKind::tailgate:
      return "tailgate";
  }
  return "";
}

FactsSection asked(const MoldingCase& values) {
  FactsSection section{"asked", "Inputs", {}};
  const auto append = [&section](const std::vector<Fact>& facts) {
    section.rows.insert(section.rows.end(), facts.begin(), facts.end());
  };
  section.rows = {
      {"Part", std::string(part_name(values.part.kind))},
      values.part.thickness ? Fact{"Thickness", *values.part.thickness, "m"}
                            : Fact{"Thickness", std::string("by element")},
      {"Melt", values.machine.melt_temperature, "K"},
      {"Mold", values.machine.mold_temperature, "K"},
      {"Fiber volume fraction", values.fibers.volume_fraction},
      {"Coupling",
       std::string(values.fibers.coupling == CouplingChoice::none ? "none" : "informed isotropic")}};
  if (values.fibers.length) section.rows.push_back({"Length at the gates", *values.fibers.length, "m"});
  append(law_facts(viscosity_menu(), "Viscosity", values.melt));
  append(law_facts(orientation_menu(), "Orientation", values.orientation));
  append(law_facts(attrition_menu(), "Length", values.law));
  append(law_facts(attrition_menu(), "Compared with", values.compared));
  return section;
}

FactsSection came_out(const SummaryFile& summary) {
  FactsSection section{"outcome", "Results", {}};
  section.rows = {{"End", summary.text("filling_end")},
                  {"Filled share of the cavity", summary.number("filled_fraction")},
                  {"Time", summary.number("simulated_s"), "s"},
                  {"Greatest pressure at the sprue", summary.number("greatest_sprue_pressure_Pa"), "Pa"},
                  {"Volume of the part", 1e6 * summary.number("volume_m3"), "cm^3"},
                  {"L_N of the part", summary.number("L_N_m"), "m"},
                  {"L_W of the part", summary.number("L_W_m"), "m"},
                  {"A_2 of the part", summary.tensor("A2"), "", "in the axes of the part"},
                  {"Volume lost or made", summary.number("volume_error"), "", "over the volume of the part"},
                  {"Heat lost or made", summary.number("heat_error"), "", "over the heat that came in"}};
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
           {"Largest memory", summary.number("peak_memory_bytes") / 1048576, "MiB"}}};
}

/// Draws the pressures at sprue and gates, or the flow rates.
LinesSection gate_section(const std::string& id, const std::string& title, const ReportAxis& y,
                          const std::string& ending, const CsvTable& series) {
  LinesSection section{id, title, {"time", "s"}, y, series.column("time_s"), {}};
  for (std::size_t i = 0; i < series.columns.size(); ++i) {
    const std::string& column = series.columns[i];
    if (!column.ends_with(ending)) continue;
    const std::string label = column.substr(0, column.size() - ending.size());
    const bool whole = label == "sprue" || label == "flow";
    std::vector<double> numbers = series.values[i];
    if (y.unit == "cm^3/s")
      for (double& number : numbers) number *= 1e6;
    section.series.push_back({label == "flow" ? "machine" : label, std::move(numbers),
                              whole ? CurveStyle::line : CurveStyle::dashed});
  }
  return section;
}

void add_tables(const MoldingCase& values, const ResultFolder& folder, std::vector<ReportSection>& sections) {
  const auto table = [&folder](const char* name) -> std::optional<CsvTable> {
    // The summary is written last: without it, tables may lack.
    if (!std::filesystem::exists(folder.summary()) || !std::filesystem::exists(folder.file(name)))
      return std::nullopt;
    return read_csv(folder.file(name));
  };
  if (const auto places = table("places.csv")) sections.emplace_back(places_section(values, *places));
  if (const auto profiles = table("profiles.csv"))
    for (LinesSection& section : profile_sections(values, *profiles))
      sections.emplace_back(std::move(section));
  if (const auto histogram = table("histogram.csv"))
    sections.emplace_back(molding_histogram(values, *histogram));
  if (const auto sweep = table("sweep.csv")) {
    sections.emplace_back(sweep_section(values, *sweep));
    sections.emplace_back(measured_section(values, *table("places.csv"), SummaryFile(folder.summary())));
  }
}

}  // namespace

ReportDocument report_molding(const MoldingCase& values, const ResultFolder& folder) {
  ReportDocument document;
  document.title = "Mold filling";
  document.stop_reason = "unfinished";
  document.sections.emplace_back(asked(values));
  const bool finished = std::filesystem::exists(folder.summary());
  if (finished) {
    const SummaryFile summary(folder.summary());
    document.stop_reason = summary.text("stop_reason");
    document.sections.emplace_back(came_out(summary));
  }
  const CsvTable series = read_csv(folder.series());
  document.sections.emplace_back(part_section(values, folder));
  LinesSection pressures =
      gate_section("pressure", "Pressure at sprue and gates", {"pressure", "Pa"}, "_pressure_Pa", series);
  pressures.caption =
      "Once the volume of the cavity is in, the sprue keeps the machine's last pressure, and those of the "
      "gates are what still moves melt to the last free places.";
  document.sections.emplace_back(std::move(pressures));
  document.sections.emplace_back(
      gate_section("rate", "Flow rates", {"flow rate", "cm^3/s"}, "_rate_m3_per_s", series));
  document.sections.emplace_back(LinesSection{"filled",
                                              "Filled share of the cavity",
                                              {"time", "s"},
                                              {"filled"},
                                              series.column("time_s"),
                                              {{"filled", series.column("filled_fraction")}}});
  add_tables(values, folder, document.sections);
  if (finished) document.sections.emplace_back(effort(SummaryFile(folder.summary())));
  return document;
}

}  // namespace fiberfate
