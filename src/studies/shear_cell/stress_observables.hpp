// The columns of series.csv that tell the stress and the power of the fibers.
#pragma once

#include "calibration/block_average.hpp"
#include "studies/shear_cell/observables.hpp"

namespace fiberfate {

/// Stresses, viscosities and powers, means since the row before; NaN where nothing was read.
[[nodiscard]] Observables<CellMoment> stress_observables();

/// What is averaged over the stationary part of a run.
enum class Rheology {
  relative_viscosity,
  first_normal_difference,
  second_normal_difference,
  elongational_viscosity
};
inline constexpr std::size_t rheologies = 4;

/// Collects one value a row of series.csv of what is averaged, with its time.
class StressHistory {
 public:
  /// Goes on from numbers() of an earlier process.
  explicit StressHistory(std::vector<double> numbers = {}) : numbers_(std::move(numbers)) {}
  void add(const CellMoment& moment);
  [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }
  /// The mean over the rows from a time on; of no values where there are none.
  [[nodiscard]] BlockMean mean(Rheology what, double from) const;

 private:
  std::vector<double> numbers_;  // time, then the rheologies, row after row
};

/// Adds the means with their errors to a summary.
void summarise_stress(const StressHistory& history, double from, RunSummary& summary);

}  // namespace fiberfate
