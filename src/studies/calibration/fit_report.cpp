// Draws residuals, parity and correlations of a fit.
#include "studies/calibration/fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/law_facts.hpp"

namespace fiberfate {
namespace {

/// Over what residuals are drawn.
enum class ResidualAxis { time, length, name };

ResidualAxis axis_of(const MeasuredSeries& one) {
  if (one.observed == Observed::histogram) return ResidualAxis::length;
  return one.place.empty() && one.values.size() > 1 ? ResidualAxis::time : ResidualAxis::name;
}

LinesSection empty_picture(ResidualAxis axis, const FitName& name) {
  LinesSection section{"residuals", "Residuals" + name.heading, {}, {"(measured − fitted)/uncertainty"}, {},
                       {}};
  section.legend = LegendValues::none;
  if (axis == ResidualAxis::time) section.x = {"time", "s"};
  if (axis == ResidualAxis::length) {
    section.id += "_of_lengths";
    section.title = "Residuals of histograms" + name.heading;
    section.x = {"length", "m"};
  }
  if (axis == ResidualAxis::name) section.id += "_of_places";
  section.id += name.prefix;
  return section;
}

/// The name under which a value without a time stands on an axis.
std::string category(const MeasuredSeries& one, const CalibrationCase& values, const FitName& name) {
  if (one.place.empty()) return one.name;
  if (!name.prefix.empty() || values.conditions.names.size() == 1) return one.place;
  return values.conditions.names[one.condition] + ": " + one.place;
}

/// Gives the place of a name on an axis, which gets it where it is new.
double place_on(std::vector<std::string>& names, const std::string& name) {
  auto found = std::ranges::find(names, name);
  if (found == names.end()) found = names.insert(names.end(), name);
  return static_cast<double>(1 + (found - names.begin()));
}

/// The label of points: those over names differ by what was measured there.
std::string label_of(const MeasuredSeries& one) {
  if (axis_of(one) != ResidualAxis::name) return one.name;
  if (one.place.empty()) return "values";
  return one.observed == Observed::number_average ? "L_N" : "L_W";
}

ReportSeries& series_called(LinesSection& section, const std::string& label) {
  const auto found = std::ranges::find(section.series, label, &ReportSeries::label);
  if (found != section.series.end()) return *found;
  section.series.push_back({label, {}, CurveStyle::points});
  section.series.back().colour = static_cast<int>(section.series.size()) - 1;
  return section.series.back();
}

std::vector<double> places_of(const MeasuredSeries& one, const std::vector<double>& times) {
  if (one.observed != Observed::histogram) return times;
  std::vector<double> middles;
  for (std::size_t i = 0; i + 1 < one.edges.size(); ++i)
    middles.push_back(0.5 * (one.edges[i] + one.edges[i + 1]));
  return middles;
}

/// What a line across points spans: from their least to their largest, or from zero where that is near.
class Ends {
 public:
  void take(const std::vector<double>& numbers) {
    for (const double number : numbers) {
      low_ = std::min(low_, number);
      high_ = std::max(high_, number);
    }
  }
  [[nodiscard]] double low() const { return low_ > 0 && low_ < 0.35 * high_ ? 0 : low_; }
  [[nodiscard]] double high() const { return high_; }

 private:
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

/// Lays the band of two uncertainties behind the points.
void append_band(LinesSection& section) {
  Ends ends;
  for (const ReportSeries& one : section.series) ends.take(one.x);
  double low = ends.low(), high = ends.high();
  if (!section.x.names.empty()) {
    low = 0.5;
    high = static_cast<double>(section.x.names.size()) + 0.5;
  }
  ReportSeries band{"two uncertainties", {0, 0}, CurveStyle::dashed, {low, high}, {-2, -2}, {2, 2}};
  band.colour = static_cast<int>(section.series.size());
  section.series.insert(section.series.begin(), std::move(band));
}

/// A quantity that shares a picture, with its unit.
std::string quantity_of(const MeasuredSeries& one) {
  switch (one.observed) {
    case Observed::orientation:
      return "component of the orientation tensor";
    case Observed::rate_constant:
      return "rate constant";
    case Observed::histogram:
      return "share of the fibers";
    case Observed::number_average:
    case Observed::weight_average:
    case Observed::final_length:
      break;
  }
  return "length";
}

LinesSection& picture_of(std::vector<LinesSection>& pictures, const MeasuredSeries& one,
                         const FitName& name) {
  const std::string quantity = quantity_of(one), y = "fitted " + quantity;
  const auto found = std::ranges::find_if(pictures, [&](const LinesSection& p) { return p.y.label == y; });
  if (found != pictures.end()) return *found;
  const std::string unit = shown_unit(one.unit);
  LinesSection section{fmt::format("parity_{}{}", pictures.size(), name.prefix),
                       "Fitted against measured" + name.heading,
                       {"measured " + quantity, unit},
                       {y, unit},
                       {},
                       {}};
  section.legend = LegendValues::none;
  return pictures.insert(pictures.end(), std::move(section))[0];
}

/// Draws the line on which fitted and measured values are equal.
void append_diagonal(LinesSection& section) {
  Ends ends;
  for (const ReportSeries& one : section.series) {
    ends.take(one.x);
    ends.take(one.values);
  }
  const std::vector<double> line = {ends.low(), ends.high()};
  section.series.push_back({"equal", line, CurveStyle::dashed, line});
}

}  // namespace

std::vector<LinesSection> residual_sections(const CalibrationCase& values,
                                            const std::vector<MeasuredSeries>& measured,
                                            const FitTables& rows) {
  std::vector<LinesSection> sections;
  for (const ResidualAxis axis : {ResidualAxis::time, ResidualAxis::length, ResidualAxis::name}) {
    LinesSection section = empty_picture(axis, rows.name);
    for (std::size_t s = 0; s < measured.size(); ++s) {
      const MeasuredSeries& one = measured[s];
      if (axis_of(one) != axis) continue;
      const auto column = [&](const char* name) {
        return pick(rows.fit, rows.name.number, static_cast<double>(s), name);
      };
      const std::vector<double> observed = column("observed"), predicted = column("predicted"),
                                uncertainty = column("uncertainty"), at = places_of(one, column("time_s"));
      ReportSeries& points = series_called(section, label_of(one));
      const double place =
          axis == ResidualAxis::name ? place_on(section.x.names, category(one, values, rows.name)) : 0;
      for (std::size_t i = 0; i < observed.size(); ++i) {
        points.x.push_back(axis == ResidualAxis::name ? place : at.at(i));
        points.values.push_back((observed[i] - predicted[i]) / uncertainty[i]);
      }
    }
    if (section.series.empty()) continue;
    append_band(section);
    sections.push_back(std::move(section));
  }
  return sections;
}

std::vector<LinesSection> parity_sections(const std::vector<MeasuredSeries>& measured,
                                          const FitTables& rows) {
  std::vector<LinesSection> pictures;
  for (std::size_t s = 0; s < measured.size(); ++s) {
    LinesSection& picture = picture_of(pictures, measured[s], rows.name);
    ReportSeries& points = series_called(picture, label_of(measured[s]));
    const auto number = static_cast<double>(s);
    append(points.x, pick(rows.fit, rows.name.number, number, "observed"));
    append(points.values, pick(rows.fit, rows.name.number, number, "predicted"));
  }
  for (LinesSection& picture : pictures) append_diagonal(picture);
  return pictures;
}

std::vector<HeatmapSection> correlation_sections(const std::vector<std::string>& parameters,
                                                 const SummaryFile& summary, const FitName& name) {
  if (parameters.size() < 3) return {};
  HeatmapSection section{
      "correlation" + name.prefix, "Correlation of the parameters" + name.heading, {}, {}, {}, {}, {}};
  section.x.names = section.y.names = parameters;
  std::ranges::reverse(section.y.names);  // the first row is the lowest
  section.values.assign(parameters.size(), std::vector<double>(parameters.size(), 1.0));
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      section.values[i][k] = section.values[k][i] =
          summary.number(fmt::format("{}correlation_{}_{}", name.prefix, parameters[k], parameters[i]));
  if (std::isnan(section.values[1][0])) return {};
  std::ranges::reverse(section.values);
  section.label = "correlation";
  section.range = {-1, 1};
  section.colours = ColourScale::diverging;
  section.cells = HeatmapSection::Cells::written;
  section.caption = "Near −1 and 1 one parameter makes up for another: the data cannot tell them apart.";
  return {std::move(section)};
}

}  // namespace fiberfate
