// What a study measures again and again: one row a quantity, from which tables, summaries and charts follow.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "io/csv_table.hpp"
#include "results/report_document.hpp"
#include "results/summary.hpp"

namespace fiberfate {

/// How the last value of an observable stands in summary.json, beside what every summary tells.
enum class InSummary { no, as_number, as_count };

/// Whether a curve is drawn that is zero throughout; where it is not, the caption says so.
enum class IfZero { drawn, left_out };

/// Whether all numbers are zero but for round-off of numbers of order 1.
[[nodiscard]] inline bool is_zero(const std::vector<double>& numbers) {
  constexpr double round_off = 1e-12;
  return std::ranges::all_of(numbers, [](double number) { return std::abs(number) < round_off; });
}

/// One number that is measured of a moment of a run. Its column is its name everywhere: in series.csv, in
/// summary.json, in Python.
template <class Moment>
struct Observable {
  std::string column;      ///< with its unit at the end, "L_N_m"
  std::string unit = {};   ///< "m"; empty for a pure number
  std::string label = {};  ///< in a chart, "L_N"
  std::string group = {};  ///< the chart that shows it; empty: none does
  std::function<double(const Moment&)> measure = {};
  InSummary in_summary = InSummary::no;
  CurveStyle style = CurveStyle::line;
  IfZero if_zero = IfZero::drawn;
};

template <class Moment>
using Observables = std::vector<Observable<Moment>>;

/// A chart over time of the observables of one group, in their unit.
struct Chart {
  std::string group;  ///< also the id of the report's section
  std::string title;
  std::string label;  ///< of the axis
  AxisScale scale = AxisScale::linear;
};

template <class Moment>
[[nodiscard]] std::vector<std::string> columns_of(const Observables<Moment>& observables) {
  std::vector<std::string> columns;
  for (const Observable<Moment>& one : observables) columns.push_back(one.column);
  return columns;
}

/// Measures one row of the table.
template <class Moment>
[[nodiscard]] std::vector<double> measure(const Observables<Moment>& observables, const Moment& moment) {
  std::vector<double> row;
  row.reserve(observables.size());
  for (const Observable<Moment>& one : observables) row.push_back(one.measure(moment));
  return row;
}

/// Adds the values of the last moment to a summary.
template <class Moment>
void summarise(const Observables<Moment>& observables, const Moment& last, RunSummary& summary) {
  for (const Observable<Moment>& one : observables) {
    if (one.in_summary == InSummary::as_number) summary.own.emplace_back(one.column, one.measure(last));
    if (one.in_summary == InSummary::as_count)
      summary.own.emplace_back(one.column, static_cast<std::int64_t>(one.measure(last)));
  }
}

/// Draws the charts that have observables, from the table that these fill.
template <class Moment>
[[nodiscard]] std::vector<LinesSection> draw(const std::vector<Chart>& charts,
                                             const Observables<Moment>& observables, const CsvTable& series) {
  std::vector<LinesSection> sections;
  for (const Chart& chart : charts) {
    LinesSection section{
        chart.group, chart.title, {"time", "s"}, {chart.label, "", chart.scale}, series.column("time_s"), {}};
    for (const Observable<Moment>& one : observables) {
      if (one.group != chart.group) continue;
      section.y.unit = one.unit;
      if (one.if_zero == IfZero::left_out && is_zero(series.column(one.column))) {
        section.caption += (section.caption.empty() ? "0 throughout and not drawn: " : ", ") + one.label;
        continue;
      }
      section.series.push_back({one.label, series.column(one.column), one.style});
    }
    if (!section.caption.empty()) section.caption += ".";
    if (!section.series.empty()) sections.push_back(std::move(section));
  }
  return sections;
}

/// The components of a symmetric tensor as observables, in the order 11, 22, 33, 12, 13, 23: columns
/// prefix + "11" + suffix. Where a label is given they are drawn in a group as label_11, …
struct TensorColumns {
  std::string prefix, suffix = {}, unit = {}, label = {}, group = {};
  CurveStyle off_diagonal = CurveStyle::line;
};
template <class Moment>
[[nodiscard]] Observables<Moment> tensor_observables(const TensorColumns& names,
                                                     const std::function<Mat3(const Moment&)>& tensor) {
  Observables<Moment> all;
  for (const auto& [i, j] : {std::pair{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}) {
    const std::string pair = std::to_string(i + 1) + std::to_string(j + 1);
    all.push_back({names.prefix + pair + names.suffix, names.unit,
                   names.group.empty() ? "" : names.label + '_' + pair, names.group,
                   [tensor, i = i, j = j](const Moment& moment) { return tensor(moment)(i, j); },
                   InSummary::no, i == j ? CurveStyle::line : names.off_diagonal,
                   i == j ? IfZero::drawn : IfZero::left_out});
  }
  return all;
}

/// Several tables of observables as one.
template <class Moment>
[[nodiscard]] Observables<Moment> joined(const std::vector<Observables<Moment>>& tables) {
  Observables<Moment> all;
  for (const Observables<Moment>& table : tables) all.insert(all.end(), table.begin(), table.end());
  return all;
}

}  // namespace fiberfate
