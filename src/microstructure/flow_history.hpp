// The homogeneous flow over time that fibers, orientation and lengths follow.
#pragma once

#include <cstddef>
#include <vector>

#include "microstructure/flow.hpp"

namespace fiberfate {

/// One row of a history: this flow at that time.
struct FlowRow {
  double time = 0;  ///< s
  Flow flow;
};

/// What happens between two rows; the last one holds for ever.
enum class HistoryForm {
  steps,  ///< each row holds until the next row's time
  ramps,  ///< gradient, viscosity, temperature and pressure change linearly from row to row
};

/// A flow that is constant for `duration`.
struct FlowPart {
  double duration = 0;  ///< s
  Flow flow;
};

/// A velocity gradient, a viscosity, a temperature and a pressure over time. Steps of integrators end where a
/// history of steps changes, so that it is followed exactly.
class FlowHistory {
 public:
  /// Takes rows of strictly rising times, the first 0; raises InputError for others, for none, and for
  /// numbers that are not finite or, but for those of the gradient, negative.
  explicit FlowHistory(std::vector<FlowRow> rows, HistoryForm form = HistoryForm::steps);
  /// Makes a flow that never changes.
  static FlowHistory constant(const Flow& flow);
  /// Makes a simple shear that never changes.
  static FlowHistory constant(double rate, double viscosity);
  /// Makes the ramp of thesis figure 3.24: `steps` equal steps from rate/steps to rate within `duration`,
  /// then rate.
  static FlowHistory ramp(double rate, double viscosity, double duration, int steps);

  /// Makes steps that repeat for ever: the rows of one period, all before its end.
  static FlowHistory repeated(std::vector<FlowRow> rows, double period);

  /// Cuts every ramp into `pieces` equal steps that take the flow of their middle: the deviation of A2 falls
  /// with pieces squared.
  [[nodiscard]] FlowHistory in_steps(int pieces) const;

  /// The flow at a time; of steps, that on [time, next_change(time)).
  [[nodiscard]] Flow at(double time) const;
  /// The time of the next row after `time`; infinity after the last.
  [[nodiscard]] double next_change(double time) const;
  /// Cuts the time from `begin` to `end` into parts of constant flow. Steps are exact. A ramp is cut into
  /// parts of at most a hundredth of its length that take the flow at their middle: second order, error below
  /// 1e-4 of the change. Raises InputError unless 0 <= begin <= end.
  [[nodiscard]] std::vector<FlowPart> parts(double begin, double end) const;

  [[nodiscard]] const std::vector<FlowRow>& rows() const { return rows_; }
  [[nodiscard]] HistoryForm form() const { return form_; }

 private:
  /// A row, and how many periods have ended before it holds.
  struct Place {
    double periods = 0;
    std::size_t row = 0;
  };
  [[nodiscard]] Place place_at(double time) const;
  [[nodiscard]] Place next(const Place& place) const;
  /// When a row begins to hold, s. Always this expression, so that times compare alike wherever they come
  /// from.
  [[nodiscard]] double begin_of(const Place& place) const {
    return place.periods > 0 ? place.periods * period_ + rows_[place.row].time : rows_[place.row].time;
  }
  [[nodiscard]] bool is_last(std::size_t row) const;
  [[nodiscard]] bool is_ramp(std::size_t row) const;
  std::vector<FlowRow> rows_;
  HistoryForm form_;
  double period_ = 0;  // 0: nothing is repeated
};

/// Raises InputError for a history of ramps, which nobody who asks for the next change can follow.
void require_steps(const FlowHistory& history);

}  // namespace fiberfate
