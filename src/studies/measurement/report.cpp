// Builds the report of the study measurement from the files of its result folder.
#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "io/csv_table.hpp"
#include "results/report_document.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/measurement/length_report.hpp"
#include "studies/measurement/run.hpp"

namespace fiberfate {
namespace {

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

FactsSection asked(const MeasurementCase& values) {
  FactsSection section{"asked", "Inputs", {}};
  if (!values.lengths.file.empty()) {
    section.rows.push_back({"Lengths", file_name(values.lengths.file)});
    if (values.lengths.sample_diameter)
      section.rows.push_back({"Diameter of the sampled region", *values.lengths.sample_diameter, "m",
                              "longer fibers are likelier to cross it, and count less"});
  }
  if (!values.orientation.file.empty()) {
    section.rows.push_back({"Directions", file_name(values.orientation.file)});
    if (values.orientation.cut_normal)
      section.rows.push_back({"Found on a cut",
                              fmt::format("normal ({})", fmt::join(*values.orientation.cut_normal, ", ")), "",
                              "fibers along the normal are likelier to be met, and count less"});
  }
  section.rows.push_back({"Confidence of the intervals", 100 * values.statistics.level, "%",
                          fmt::format("{} bootstrap samples", values.statistics.resamples)});
  return section;
}

TableSection orientation_table(const SummaryFile& summary) {
  TableSection section{"orientation",
                       "Components of the orientation tensor",
                       {{"component"}, {"value"}, {"low"}, {"high"}},
                       {}};
  const Mat3 estimate = summary.tensor("A2"), lower = summary.tensor("A2_lower"),
             upper = summary.tensor("A2_upper");
  for (const auto& [i, j] : {std::pair(0, 0), {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}) {
    section.rows.push_back({fmt::format("a_{}{}", i + 1, j + 1), estimate(i, j), lower(i, j), upper(i, j)});
  }
  section.role = SectionRole::detail;
  return section;
}

/// Draws the components with their intervals beside each other.
LinesSection components(const MeasurementCase& values, const SummaryFile& summary) {
  LinesSection section{"components", "Orientation tensor", {"component"}, {"value"}, {}, {}};
  const Mat3 estimate = summary.tensor("A2"), lower = summary.tensor("A2_lower"),
             upper = summary.tensor("A2_upper");
  ReportSeries points{"orientation tensor", {}, CurveStyle::points};
  for (const auto& [i, j] : {std::pair(0, 0), {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}) {
    section.x.names.push_back(fmt::format("a_{}{}", i + 1, j + 1));
    points.x.push_back(static_cast<double>(section.x.names.size()));
    points.values.push_back(estimate(i, j));
    points.low.push_back(lower(i, j));
    points.high.push_back(upper(i, j));
  }
  section.series = {std::move(points)};
  section.legend = LegendValues::none;
  section.caption = fmt::format("Bars: {:g} % by bootstrap over {} directions.",
                                100 * values.statistics.level, summary.count("measured_directions"));
  return section;
}

std::vector<Fact> direction_facts(const SummaryFile& summary) {
  const Mat3 estimate = summary.tensor("A2"), lower = summary.tensor("A2_lower"),
             upper = summary.tensor("A2_upper");
  return {{"a_11", estimate(0, 0), "", fmt::format("{:.3f} to {:.3f}", lower(0, 0), upper(0, 0)),
           Prominence::headline},
          {"Orientation tensor", estimate},
          {"Directions measured", summary.count("measured_directions")}};
}

HeatmapSection pole_figure(const ResultFolder& folder) {
  const CsvTable table = read_rows(folder.file("directions.csv"));
  HeatmapSection section{"directions", "Where fibers point",   {"phi", "°"}, {"cos theta"}, {}, {},
                         {},           "density over the mean"};
  const std::vector<double>&azimuths = table.column("phi_deg"), &heights = table.column("cos_theta"),
        &densities = table.column("density");
  for (std::size_t k = 0; k < table.rows(); ++k) add_cell(section, {azimuths[k], heights[k]}, densities[k]);
  section.caption =
      "theta from axis 3, phi from axis 1 towards axis 2; bins of equal solid angle, 1 is isotropic.";
  return section;
}

}  // namespace

ReportDocument report_measurement(const MeasurementCase& values, const ResultFolder& folder) {
  const SummaryFile summary(folder.summary());
  ReportDocument document{"Measured fibers"};
  FactsSection results{"outcome", "Results", {}};
  std::vector<ReportSection> sections;
  if (!values.lengths.file.empty()) {
    append(results.rows, length_facts(values, summary, folder));
    append(sections, length_sections(values, summary, folder));
  }
  if (!values.orientation.file.empty()) {
    append(results.rows, direction_facts(summary));
    sections.emplace_back(components(values, summary));
    sections.emplace_back(pole_figure(folder));
    sections.emplace_back(orientation_table(summary));
  }
  document.sections.emplace_back(asked(values));
  document.sections.emplace_back(std::move(results));
  append(document.sections, std::move(sections));
  return document;
}

}  // namespace fiberfate
