// The report of the study calibration from the files of its result folder.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/csv_table.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/calibration/fit_report.hpp"
#include "studies/calibration/fits.hpp"
#include "studies/calibration/mold_report.hpp"
#include "studies/calibration/parameter_report.hpp"
#include "studies/calibration/run.hpp"
#include "studies/law_facts.hpp"

namespace fiberfate {
namespace {

FactsSection asked(const CalibrationCase& values) {
  FactsSection section{"asked", "Inputs", law_facts(calibrated_menu(values), "Law", calibrated_law(values))};
  section.rows.push_back({"Fitted", fmt::format("{}", fmt::join(values.search.free, ", "))});
  if (calibrates_orientation(values)) section.rows.push_back({"Closure", values.closure});
  for (const std::vector<std::string>& row : values.data.series)
    section.rows.push_back({row[0] + ": " + row[1], std::filesystem::path(row[2]).filename().string()});
  const auto& moldings = values.conditions.moldings;
  for (std::size_t i = 0; i < values.conditions.names.size() && !moldings.empty(); ++i) {
    std::vector<std::string> row = entry(moldings, i);
    row[0] = std::filesystem::path(row[0]).filename().string();
    section.rows.push_back({values.conditions.names[i], fmt::format("{}", fmt::join(row, ", "))});
  }
  return section;
}

std::string freedom_in_words(std::int64_t freedom) {
  return freedom == 1 ? "1 degree of freedom" : fmt::format("{} degrees of freedom", freedom);
}

FactsSection quality(const CalibrationCase& values, const SummaryFile& summary, const FitName& name) {
  const auto key = [&](const char* text) { return name.prefix + text; };
  const Prominence prominence = name.prefix.empty() ? Prominence::headline : Prominence::ordinary;
  FactsSection section{"quality" + name.prefix, "The fit" + name.heading,
                       parameter_facts(values, summary, name)};
  append(section.rows, misfit_facts(values, summary, name));
  for (int i = 1; !summary.text(key("finding_") + std::to_string(i)).empty(); ++i)
    section.rows.push_back({fmt::format("Finding {}", i), summary.text(key("finding_") + std::to_string(i))});
  append(section.rows, correlation_facts(free_names(values), summary, name));
  append<Fact, Fact>(section.rows, {{"Average error", summary.number(key("average_error_percent")), "%",
                                     "of the fitted values", prominence},
                                    {"Observations", summary.count(key("observations")), "",
                                     freedom_in_words(summary.count(key("degrees_of_freedom"))), prominence},
                                    {"Sum of weighted squares", summary.number(key("chi_square"))},
                                    {"Scatter of the data", summary.number(key("noise_scale")), "",
                                     "over the given uncertainties"},
                                    {"Converged", summary.text(key("converged"))}});
  return section;
}

/// Gives every point a bar of one uncertainty to either side.
void append_bars(ReportSeries& points, const std::vector<double>& uncertainties) {
  for (std::size_t i = 0; i < points.values.size(); ++i) {
    points.low.push_back(points.values[i] - uncertainties.at(i));
    points.high.push_back(points.values[i] + uncertainties.at(i));
  }
}

/// Draws what was measured with the fitted curve and its band; series of one quantity share a picture.
std::vector<LinesSection> curves_sections(const std::vector<MeasuredSeries>& measured, const FitTables& rows,
                                          double level) {
  const auto& [name, fit, curves] = rows;
  std::vector<LinesSection> pictures;
  for (std::size_t s = 0; s < measured.size(); ++s) {
    const MeasuredSeries& one = measured[s];
    if (one.values.size() < 2 || one.observed == Observed::histogram) continue;
    const std::string quantity =
        one.observed == Observed::orientation ? "component of the orientation tensor" : "length";
    auto picture =
        std::ranges::find_if(pictures, [&](const LinesSection& p) { return p.y.label == quantity; });
    if (picture == pictures.end()) {
      LinesSection section{
          "curves_" + std::to_string(pictures.size()) + name.prefix,
          "Measured and fitted" + name.heading,
          {"time", "s"},
          {quantity, shown_unit(one.unit)},
          {},
          {},
          fmt::format("Bars: the uncertainties of the data. Bands: where another measurement "
                      "would lie, with {:g} %; that of the curve itself is in curves.csv.",
                      100 * level)};
      picture = pictures.insert(pictures.end(), std::move(section));
    }
    const auto number = static_cast<double>(s);
    ReportSeries curve{one.name, pick(curves, name.number, number, "predicted")};
    curve.x = pick(curves, name.number, number, "time_s");
    curve.low = pick(curves, name.number, number, "observation_low");
    curve.high = pick(curves, name.number, number, "observation_high");
    ReportSeries points{one.name + ", measured", pick(fit, name.number, number, "observed"),
                        CurveStyle::points};
    points.x = pick(fit, name.number, number, "time_s");
    append_bars(points, pick(fit, name.number, number, "uncertainty"));
    curve.colour = points.colour = static_cast<int>(picture->series.size()) / 2;
    picture->series.push_back(std::move(curve));
    picture->series.push_back(std::move(points));
  }
  return pictures;
}

/// Draws the error over the swept parameter, one curve a fit.
void append_sweep(const CalibrationCase& values, const ResultFolder& folder, const SummaryFile& summary,
                  std::vector<ReportSection>& sections) {
  if (values.sweep.parameter.empty() || !std::filesystem::exists(folder.file("sweep.csv"))) return;
  const CsvTable table = read_csv(folder.file("sweep.csv"));
  const AxisScale scale =
      values.sweep.spacing == ParameterScale::logarithmic ? AxisScale::logarithmic : AxisScale::linear;
  LinesSection section{"sweep",
                       "Error over " + values.sweep.parameter,
                       {values.sweep.parameter, "", scale},
                       {"average error", "%"},
                       {},
                       {}};
  for (const FitName& name : fit_names(values)) {
    ReportSeries curve{name.heading.empty() ? "average error" : name.heading.substr(2), {}};
    for (std::size_t i = 0; i < table.rows(); ++i) {
      if (table.column("fit")[i] != name.number) continue;
      curve.x.push_back(table.column("value")[i]);
      curve.values.push_back(table.column("average_error_percent")[i]);
    }
    if (curve.values.empty()) continue;
    if (summary.text(name.prefix + "coupled") == "yes") curve.style = CurveStyle::dashed;
    section.caption = fmt::format("Least at {} = {:.6g}: {:.4g} % (thesis 4.7, 4.8, figure 4.2).",
                                  values.sweep.parameter, summary.number(name.prefix + "sweep_best_value"),
                                  summary.number(name.prefix + "sweep_best_error_percent"));
    section.series.push_back(std::move(curve));
  }
  if (section.series.size() > 1)
    section.caption = "Thesis 4.7, 4.8, figures 4.6, 4.7; dashed where the flow feels the fibers.";
  sections.emplace_back(std::move(section));
}

/// Compares the optima of moldings that were fitted one by one.
void append_optima(const CalibrationCase& values, const ResultFolder& folder,
                   std::vector<ReportSection>& sections) {
  if (!std::filesystem::exists(folder.file("optimum.csv"))) return;
  const CsvTable table = read_numbered(folder.file("optimum.csv"), {"fit", fit_names(values).size()});
  sections.emplace_back(optimum_table(values, table));
  if (table.rows() > 1) sections.emplace_back(optimum_section(values, table));
}

}  // namespace

ReportDocument report_calibration(const CalibrationCase& values, const ResultFolder& folder) {
  const SummaryFile summary(folder.summary());
  ReportDocument document{"Calibration of " + calibrated_law(values).name};
  document.sections.emplace_back(asked(values));
  const CsvTable fit = read_csv(folder.file("fit.csv"));
  const CsvTable curves = read_csv(folder.file("curves.csv"));
  const std::vector<MeasuredSeries> all = read_measurements(values);
  append_optima(values, folder, document.sections);
  append_sweep(values, folder, summary, document.sections);
  for (const FitName& name : fit_names(values)) {
    const std::vector<MeasuredSeries> measured = series_of(name, all);
    if (measured.empty()) continue;
    const FitTables rows = {name, fit, curves};
    append(document.sections, calibrates_in_molds(values)
                                  ? molded_lengths_sections(values, measured, rows)
                                  : curves_sections(measured, rows, values.search.level));
    append(document.sections, residual_sections(values, measured, rows));
    append(document.sections, parity_sections(measured, rows));
    append_profiles(values, folder, name, summary, document.sections);
    append(document.sections, correlation_sections(free_names(values), summary, name));
    append_samples(values, folder, name, document.sections);
    document.sections.emplace_back(estimates(values, summary, name));
    document.sections.emplace_back(quality(values, summary, name));
  }
  return document;
}

}  // namespace fiberfate
