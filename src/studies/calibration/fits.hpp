// The fits of a calibration: one of all conditions, or one for each, and their rows in its tables.
#pragma once

#include <string>
#include <vector>

#include "io/csv_table.hpp"
#include "studies/calibration/data.hpp"

namespace fiberfate {

/// One fit of a run: its number in the tables, the prefix of its keys in summary.json, its heading.
struct FitName {
  double number = 0;
  std::string prefix = {}, heading = {};
};

/// The tables in which a fit has rows.
struct FitTables {
  FitName name;
  const CsvTable& fit;
  const CsvTable& curves;
};

/// The fits that a case asks for.
[[nodiscard]] std::vector<FitName> fit_names(const CalibrationCase& values);
/// Picks the series that belong to a fit.
[[nodiscard]] std::vector<MeasuredSeries> series_of(const FitName& fit,
                                                    const std::vector<MeasuredSeries>& all);
/// Picks the values of a column in the rows whose two leading columns are the fit and another number.
[[nodiscard]] std::vector<double> pick(const CsvTable& table, double fit, double second,
                                       const std::string& column);

}  // namespace fiberfate
