// Follows the flow and the temperature that break fibers over time.
#pragma once

#include <vector>

#include "continuum/length_flow.hpp"
#include "continuum/viscosity.hpp"

namespace fiberfate {

/// One row of a history.
struct LengthHistoryRow {
  double time = 0;         ///< s
  double rate = 0;         ///< shear rate, 1/s
  double temperature = 0;  ///< K
  double pressure = 0;     ///< Pa
};

/// Chooses what happens between two rows.
enum class HistoryForm {
  steps,  ///< each row holds until the next row's time, the last for ever
  ramps,  ///< rate, temperature and pressure change linearly between rows; the last row holds for ever
};

/// A flow that is constant for `duration`.
struct LengthHistoryPart {
  double duration = 0;  ///< s
  MeltState melt;
};

/// A history of rate, temperature and pressure as rows of rising time.
class LengthHistory {
 public:
  /// Raises InputError unless there is a row, times rise from 0 on, rates and pressures are not negative, and
  /// all numbers are finite.
  LengthHistory(std::vector<LengthHistoryRow> rows, HistoryForm form);
  /// Makes a history that never changes.
  static LengthHistory constant(const MeltState& melt);

  /// Rate, temperature and pressure at a time.
  [[nodiscard]] MeltState at(double time) const;
  /// Cuts the time from `begin` to `end` into parts of constant state. Steps are exact. A ramp is cut into
  /// parts of at most a hundredth of its length that take the state at their middle: second order, error
  /// below 1e-4 of the change. Raises InputError unless 0 <= begin <= end.
  [[nodiscard]] std::vector<LengthHistoryPart> parts(double begin, double end) const;
  [[nodiscard]] const std::vector<LengthHistoryRow>& rows() const { return rows_; }

 private:
  [[nodiscard]] std::size_t row_at(double time) const;
  std::vector<LengthHistoryRow> rows_;
  HistoryForm form_;
};

}  // namespace fiberfate
