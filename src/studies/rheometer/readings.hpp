// What a run of a cell is read for: the columns of rheometer.csv, and the stresses that they mean.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/csv_table.hpp"
#include "studies/rheometer/case.hpp"
#include "studies/rheometer/stress_fit.hpp"
#include "studies/shear_cell/observables.hpp"

namespace fiberfate {

/// The quantities with an error: the mean's column and that of its standard error.
struct ErrorColumns {
  const char *mean, *error;
};
[[nodiscard]] std::span<const ErrorColumns> columns_with_errors();

/// What is averaged over the stationary part of a run: columns of series.csv (docs/formats/series.md).
[[nodiscard]] const Observables<CellMoment>& averaged_observables();

/// Which run a row of rheometer.csv tells of.
struct RunPlace {
  std::size_t point = 0;
  std::int64_t replica = 0;
};

/// The columns of rheometer.csv (docs/formats/rheometer.md).
[[nodiscard]] const std::vector<std::string>& reading_columns();
/// Makes the row of a run at its end from a moment and from a history of averaged_observables(), each row
/// led by its time.
[[nodiscard]] std::vector<double> reading_row(const RunPlace& place, const CellMoment& last,
                                              std::span<const double> history);

/// The stress that a row of rheometer.csv tells, with the flow of its point.
[[nodiscard]] StressReading stress_reading(const RheometerCase& values, const CsvTable& readings,
                                           std::size_t row);

}  // namespace fiberfate
