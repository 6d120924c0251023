// Builds the report of the study measurement from the files of its result folder.
#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "io/csv_table.hpp"
#include "results/report_document.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/measurement/lists.hpp"
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

TableSection lengths_table(const SummaryFile& summary) {
  TableSection section{"lengths",
                       "Mean lengths",
                       {{"average"}, {"value", "mm"}, {"low", "mm"}, {"high", "mm"}, {"uncorrected", "mm"}},
                       {}};
  for (const char* name : {"L_N", "L_W"}) {
    const auto number = [&](const char* suffix) { return 1e3 * summary.number(std::string(name) + suffix); };
    section.rows.push_back(
        {std::string(name), number("_m"), number("_lower_m"), number("_upper_m"), number("_uncorrected_m")});
  }
  const auto count = [&summary](const char* key) { return static_cast<std::size_t>(summary.count(key)); };
  const std::string left_out = LeftOut{count("left_out_empty_lines"), count("left_out_zero_lengths")}.text();
  section.caption = fmt::format("{} lengths in column '{}'{}.", summary.count("measured_lengths"),
                                summary.text("lengths_column"), left_out.empty() ? "" : "; " + left_out);
  return section;
}

HistogramSection lengths_histogram(const ResultFolder& folder, bool corrected) {
  const CsvTable table = read_rows(folder.file("histogram.csv"));
  HistogramSection section{"histogram", "Fibers by length", {"length", "m"}, {"share of the fibers", "%"}, {},
                           {}};
  section.edges = table.column("length_low_m");
  section.edges.push_back(table.column("length_high_m").back());
  const auto percent = [&table](const char* column) {
    std::vector<double> shares = table.column(column);
    for (double& share : shares) share *= 100;
    return shares;
  };
  section.frames = {{corrected ? "corrected" : "measured", percent("number_share")},
                    {"by length", percent("length_share")}};
  if (corrected) section.reference = HistogramFrame{"as measured", percent("uncorrected_number_share")};
  return section;
}

TableSection orientation_table(const SummaryFile& summary) {
  TableSection section{
      "orientation", "Orientation tensor", {{"component"}, {"value"}, {"low"}, {"high"}}, {}};
  const Mat3 estimate = summary.tensor("A2"), lower = summary.tensor("A2_lower"),
             upper = summary.tensor("A2_upper");
  for (const auto& [i, j] : {std::pair(0, 0), {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}) {
    section.rows.push_back({fmt::format("A_{}{}", i + 1, j + 1), estimate(i, j), lower(i, j), upper(i, j)});
  }
  section.caption = fmt::format("{} directions.", summary.count("measured_directions"));
  return section;
}

HeatmapSection pole_figure(const ResultFolder& folder) {
  const CsvTable table = read_rows(folder.file("directions.csv"));
  HeatmapSection section{"directions", "Where fibers point",   {"phi", "°"}, {"cos theta"}, {}, {},
                         {},           "density over the mean"};
  const std::vector<double>&azimuths = table.column("phi_deg"), &heights = table.column("cos_theta"),
        &densities = table.column("density");
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double azimuth = azimuths[k], height = heights[k];
    if (section.y_values.empty() || height != section.y_values.back()) {
      section.y_values.push_back(height);
      section.values.emplace_back();
    }
    if (section.values.size() == 1) section.x_values.push_back(azimuth);
    section.values.back().push_back(densities[k]);
  }
  section.caption =
      "theta from axis 3, phi from axis 1 towards axis 2; bins of equal solid angle, 1 is isotropic.";
  return section;
}

}  // namespace

ReportDocument report_measurement(const MeasurementCase& values, const ResultFolder& folder) {
  const SummaryFile summary(folder.summary());
  ReportDocument document{"Measured fibers"};
  document.sections.emplace_back(asked(values));
  if (!values.lengths.file.empty()) {
    document.sections.emplace_back(lengths_table(summary));
    document.sections.emplace_back(lengths_histogram(folder, values.lengths.sample_diameter.has_value()));
  }
  if (!values.orientation.file.empty()) {
    document.sections.emplace_back(orientation_table(summary));
    document.sections.emplace_back(pole_figure(folder));
  }
  return document;
}

}  // namespace fiberfate
