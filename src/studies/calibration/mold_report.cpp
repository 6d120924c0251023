// The sections of a calibration report that are about molded parts.
#include "studies/calibration/mold_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace fiberfate {
namespace {

/// Lists the places of a condition in the order in which they are measured.
std::vector<std::string> places_of(const std::vector<MeasuredSeries>& measured, std::size_t condition) {
  std::vector<std::string> places;
  for (const MeasuredSeries& one : measured)
    if (one.condition == condition && std::find(places.begin(), places.end(), one.place) == places.end())
      places.push_back(one.place);
  return places;
}

void append(std::vector<double>& all, const std::vector<double>& some) {
  all.insert(all.end(), some.begin(), some.end());
}

LinesSection lengths_section(const CalibrationCase& values, const std::vector<MeasuredSeries>& measured,
                             const FitTables& rows, std::size_t condition) {
  const std::string& name = values.conditions.names[condition];
  LinesSection section{fmt::format("lengths_{}{}", rows.name.prefix, condition),
                       "Measured and fitted lengths, " + name,
                       {"place"},
                       {"length", "m"},
                       {},
                       {}};
  const std::vector<std::string> places = places_of(measured, condition);
  section.x.names = places;
  for (const LengthMean mean : length_means) {
    const std::string label = symbol(mean);
    ReportSeries predicted{label + ", fitted", {}}, samples{label + ", measured", {}, CurveStyle::points};
    for (std::size_t s = 0; s < measured.size(); ++s) {
      if (measured[s].condition != condition || measured[s].observed != observed_mean(mean)) continue;
      const auto number = static_cast<double>(s);
      const auto place = std::find(places.begin(), places.end(), measured[s].place);
      const auto x = static_cast<double>(1 + (place - places.begin()));
      predicted.x.push_back(x);
      append(predicted.values, pick(rows.curves, rows.name.number, number, "predicted"));
      append(predicted.low, pick(rows.curves, rows.name.number, number, "observation_low"));
      append(predicted.high, pick(rows.curves, rows.name.number, number, "observation_high"));
      append(samples.values, pick(rows.fit, rows.name.number, number, "observed"));
      samples.x.resize(samples.values.size(), x);
    }
    if (predicted.values.empty()) continue;
    predicted.colour = samples.colour = static_cast<int>(section.series.size()) / 2;
    section.series.push_back(std::move(predicted));
    section.series.push_back(std::move(samples));
  }
  section.legend = LegendValues::none;
  section.caption =
      fmt::format("Bands: where another sample would lie, with {:g} %.", 100 * values.search.level);
  return section;
}

const char* coupling_name(double coupled) {
  return coupled > 0 ? "coupled" : "not coupled";
}

}  // namespace

std::vector<LinesSection> molded_lengths_sections(const CalibrationCase& values,
                                                  const std::vector<MeasuredSeries>& measured,
                                                  const FitTables& rows) {
  std::vector<LinesSection> sections;
  for (std::size_t i = 0; i < values.conditions.names.size(); ++i)
    if (!places_of(measured, i).empty()) sections.push_back(lengths_section(values, measured, rows, i));
  return sections;
}

TableSection optimum_table(const CalibrationCase& values, const CsvTable& optimum) {
  const std::string& parameter = values.sweep.parameter;
  TableSection section{"optima", "Optima of " + parameter, {}, {}};
  section.columns = {{"molding"}, {"coupling"},       {"length at the gates", "m"},
                     {"L/D"},     {"least error at"}, {"least error", "%"},
                     {"fitted"},  {"from"},           {"to"}};
  for (std::size_t i = 0; i < optimum.rows(); ++i) {
    const auto at = [&](const char* column) { return optimum.column(column)[i]; };
    const std::size_t condition =
        values.search.scope == FitScope::separately ? static_cast<std::size_t>(at("fit")) : 0;
    section.rows.push_back({values.conditions.names[condition], std::string(coupling_name(at("coupled"))),
                            at("length_m"), at("aspect_ratio"), at("best_value"), at("best_error_percent"),
                            at("fitted"), at("lower"), at("upper")});
  }
  section.caption =
      fmt::format("Least average error (4.8), and fit by least squares with its {:g} % interval.",
                  100 * values.search.level);
  return section;
}

LinesSection optimum_section(const CalibrationCase& values, const CsvTable& optimum) {
  LinesSection section{"optimum",
                       fmt::format("Optimum of {} over L/D at the gates", values.sweep.parameter),
                       {"L/D at the gates"},
                       {values.sweep.parameter},
                       {},
                       {}};
  std::vector<std::size_t> order(optimum.rows());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<double>& ratios = optimum.column("aspect_ratio");
  std::stable_sort(order.begin(), order.end(),
                   [&ratios](std::size_t a, std::size_t b) { return ratios[a] < ratios[b]; });
  for (const double coupled : {0.0, 1.0}) {
    const std::string label = coupling_name(coupled);
    ReportSeries fitted{label + ", fitted", {}, coupled > 0 ? CurveStyle::dashed : CurveStyle::line};
    ReportSeries least{label + ", least error", {}, CurveStyle::points};
    for (const std::size_t i : order) {
      if (optimum.column("coupled")[i] != coupled) continue;
      fitted.x.push_back(ratios[i]);
      fitted.values.push_back(optimum.column("fitted")[i]);
      fitted.low.push_back(optimum.column("lower")[i]);
      fitted.high.push_back(optimum.column("upper")[i]);
      least.values.push_back(optimum.column("best_value")[i]);
    }
    if (fitted.values.empty()) continue;
    least.x = fitted.x;
    fitted.colour = least.colour = static_cast<int>(section.series.size()) / 2;
    section.series.push_back(std::move(fitted));
    section.series.push_back(std::move(least));
  }
  section.caption = "Thesis figures 4.8, 4.9. Bands: intervals of the fits.";
  return section;
}

}  // namespace fiberfate
