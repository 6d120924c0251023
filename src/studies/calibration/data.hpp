// Reads what was measured.
#pragma once

#include <string>
#include <vector>

#include "studies/calibration/case.hpp"

namespace fiberfate {

/// The kinds of observation.
enum class Observed { number_average, weight_average, final_length, rate_constant, histogram, orientation };

/// A mean length that was observed.
[[nodiscard]] constexpr Observed observed_mean(LengthMean mean) {
  return mean == LengthMean::number_average ? Observed::number_average : Observed::weight_average;
}

/// One measured series of one condition.
struct MeasuredSeries {
  std::string name;           ///< "50 rpm: L_W"
  std::string unit;           ///< SI
  std::size_t condition = 0;  ///< index into conditions.names
  std::string place;          ///< of a molding; empty: none
  Observed observed = Observed::number_average;
  int row = 0, column = 0;         ///< of A2, for orientation
  std::vector<double> times;       ///< s, one a value; of histograms, all the same; of single values, 0
  std::vector<double> edges;       ///< of histograms, m, one more than values
  std::vector<double> values;      ///< SI
  std::vector<double> deviations;  ///< standard deviations, SI
};

/// Reads all series of a case. Raises InputError with the file and what is wrong, its line the
/// row of data.series, from 1.
[[nodiscard]] std::vector<MeasuredSeries> read_measurements(const CalibrationCase& values);

}  // namespace fiberfate
