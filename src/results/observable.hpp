// What a study measures again and again: one row a quantity, from which tables, summaries and charts follow.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "results/report_document.hpp"

namespace fiberfate {

/// One number that is measured of a moment of a run. Its column is its name everywhere: in series.csv, in
/// summary.json, in Python.
template <class Moment>
struct Observable {
  std::string column;      ///< with its unit at the end, "L_N_m"
  std::string unit = {};   ///< SI, "m"; empty for a pure number
  std::string label = {};  ///< in a chart, "L_N"
  std::string group = {};  ///< the chart that shows it; empty: none does
  std::function<double(const Moment&)> measure = {};
  CurveStyle style = CurveStyle::line;
};

template <class Moment>
using Observables = std::vector<Observable<Moment>>;

/// A chart of several observables over a common axis.
struct Chart {
  std::string group;  ///< of its observables; also the id of the report's section
  std::string title;
  ReportAxis y;
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

/// Draws a chart from the table that the observables' rows make.
template <class Moment>
[[nodiscard]] LinesSection draw(const Chart& chart, const Observables<Moment>& observables,
                                const ReportAxis& x, const std::vector<double>& x_values,
                                const std::function<const std::vector<double>&(const std::string&)>& column) {
  LinesSection section{chart.group, chart.title, x, chart.y, x_values, {}};
  for (const Observable<Moment>& one : observables)
    if (one.group == chart.group) section.series.push_back({one.label, column(one.column), one.style});
  return section;
}

}  // namespace fiberfate
