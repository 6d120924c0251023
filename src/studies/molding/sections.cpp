// The charts and tables of a molding report that come of places, profiles and the sweep.
#include "studies/molding/sections.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.hpp"
#include "studies/molding/observables.hpp"

namespace fiberfate {
namespace {

/// Reports tell temperatures in °C.
std::string unit_on_page(const std::string& unit) {
  return unit == "K" ? "degC" : unit;
}
double zero_on_page(const std::string& unit) {
  return unit == "K" ? zero_celsius : 0;
}

/// Picks the values of a column in the rows where other columns have these values.
std::vector<double> picked(const CsvTable& table, const std::vector<std::pair<const char*, double>>& where,
                           const std::string& column) {
  std::vector<double> values;
  for (std::size_t i = 0; i < table.rows(); ++i)
    if (std::ranges::all_of(where, [&](const auto& one) { return table.column(one.first)[i] == one.second; }))
      values.push_back(table.column(column)[i]);
  return values;
}

}  // namespace

TableSection places_section(const MoldingCase& values, const CsvTable& places) {
  TableSection section{"places", "Named places", {{"place"}, {"set"}}, {}};
  for (const Observable<PlaceSample>& one : place_observables())
    if (!one.label.empty()) section.columns.push_back({one.label, unit_on_page(one.unit)});
  for (std::size_t i = 0; i < places.rows(); ++i) {
    if (std::isfinite(places.column("value")[i])) continue;  // the sweep has a figure of its own
    const bool compared = places.column("set")[i] > 0;
    section.rows.push_back({values.output.places[static_cast<std::size_t>(places.column("place")[i])].name,
                            compared ? values.compared.name : values.law.name});
    for (const Observable<PlaceSample>& one : place_observables())
      if (!one.label.empty())
        section.rows.back().emplace_back(places.column(one.column)[i] - zero_on_page(one.unit));
  }
  section.caption =
      values.fibers.number_average
          ? "Means over the gap and over the radius of a sample. places.csv has L_N and L_W of all "
            "fibers of the sample beside them."
          : "L_N and L_W of all fibers in the gap and radius of a sample, in which layers of short "
            "fibers count the more; places.csv has the means over the gap beside them.";
  return section;
}

std::vector<LinesSection> profile_sections(const MoldingCase& values, const CsvTable& profiles) {
  std::vector<LinesSection> sections;
  for (const Chart& chart : profile_charts())
    for (const Observable<GapPoint>& one : profile_observables()) {
      if (one.group != chart.group) continue;
      if (std::ranges::none_of(profiles.column(one.column),
                               [](double value) { return std::isfinite(value); }))
        continue;
      LinesSection section{
          chart.group, chart.title, {"height over the mid-plane", "m"}, {chart.label, unit_on_page(one.unit)},
          {},          {}};
      for (std::size_t p = 0; p < values.output.places.size(); ++p) {
        const auto place = static_cast<double>(p);
        std::vector<double> shown = picked(profiles, {{"place", place}}, one.column);
        for (double& value : shown) value -= zero_on_page(one.unit);
        section.series.push_back({values.output.places[p].name, std::move(shown), CurveStyle::line,
                                  picked(profiles, {{"place", place}}, "z_m")});
      }
      section.caption =
          "From the mid-plane to the wall, at the node nearest to each place when filling ends.";
      sections.push_back(std::move(section));
    }
  return sections;
}

HistogramSection molding_histogram(const MoldingCase& values, const CsvTable& table) {
  HistogramSection section{"histogram", "Fibers by length", {"length", "m"}, {"share of the fibers", "%"}, {},
                           {}};
  const auto shares = [&table](double place) {
    std::vector<double> percent = picked(table, {{"place", place}, {"set", 0}}, "number_share");
    for (double& share : percent) share *= 100;
    return percent;
  };
  constexpr double inlet = -1;
  section.edges = picked(table, {{"place", inlet}, {"set", 0}}, "length_high_m");
  section.edges.insert(section.edges.begin(), table.column("length_low_m").front());
  for (std::size_t p = 0; p < values.output.places.size(); ++p) {
    HistogramFrame frame = {values.output.places[p].name, shares(static_cast<double>(p))};
    if (!frame.values.empty()) section.frames.push_back(std::move(frame));
  }
  section.reference = HistogramFrame{"at the gates", shares(inlet)};
  return section;
}

LinesSection sweep_section(const MoldingCase& values, const CsvTable& sweep) {
  const bool logarithmic = values.sweep.spacing == ParameterScale::logarithmic;
  return {"sweep",
          "Average error over " + values.sweep.parameter,
          {values.sweep.parameter, "", logarithmic ? AxisScale::logarithmic : AxisScale::linear},
          {"average error", "%"},
          sweep.column("value"),
          {{"average error (4.8)", sweep.column("average_error_percent")}}};
}

LinesSection measured_section(const MoldingCase& values, const CsvTable& places, const SummaryFile& summary) {
  const double best = summary.number("sweep_best_value");
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < places.rows(); ++i)
    if (std::isfinite(places.column("value")[i]) &&
        !(std::abs(std::log(places.column("value")[i] / best)) >=
          std::abs(std::log(places.column("value")[nearest] / best))))
      nearest = i;
  const double set = places.column("set")[nearest];
  LinesSection section{"measured", "Measured and predicted lengths", {"place"}, {"length", "m"}, {}, {}};
  for (const LengthMean mean : length_means) {
    const std::string label = symbol(mean);
    ReportSeries measured{label + ", measured", {}, CurveStyle::points};
    ReportSeries predicted{label + ", predicted", picked(places, {{"set", set}}, label + "_m")};
    predicted.x = picked(places, {{"set", set}}, "place");
    for (double& place : predicted.x) {
      for (const MeasuredLength& one : values.sweep.measured)
        if (one.mean == mean && one.place == values.output.places[place].name) {
          measured.x.push_back(place + 1);
          measured.values.push_back(one.length);
        }
      place += 1;
    }
    if (measured.values.empty()) continue;
    section.series.push_back(std::move(measured));
    section.series.push_back(std::move(predicted));
  }
  section.caption =
      "Places in the order of output.places; predicted with the value of the sweep nearest to the best one.";
  return section;
}

}  // namespace fiberfate
