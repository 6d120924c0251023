// Runs the cell of one point and replica in memory.
#pragma once

#include <functional>
#include <vector>

#include "dynamics/simulation.hpp"
#include "dynamics/stress_mean.hpp"
#include "results/output_schedule.hpp"
#include "studies/rheometer/readings.hpp"
#include "studies/shear_cell/run_loop.hpp"

namespace fiberfate {

/// What a run has measured so far, as plain numbers.
struct RunNotes {
  std::vector<double> stress = {};   ///< mean since the last row, as StressMean has it
  std::vector<double> history = {};  ///< rows of averaged_observables(), each led by its time
};

/// One cell that flows until its end, read at the times at which the study shear_cell writes rows.
class CellRun {
 public:
  /// Goes on from a state and from notes of an earlier process.
  CellRun(ShearCellCase cell, FiberState state, const RunNotes& notes = {});
  /// The simulated time at which the run ends, s.
  [[nodiscard]] double end() const { return series_times_.snapped(cell_.run.duration); }
  [[nodiscard]] bool has_ended() const { return simulation_.state().time >= end(); }
  [[nodiscard]] const FiberState& state() const { return simulation_.state(); }
  [[nodiscard]] RunNotes notes() const { return {stress_.numbers(), history_}; }
  /// Runs; `limits` say when to stop before the end. Raises SimulationFailure.
  RunOutcome run(RunLimits limits, const std::function<void()>& checkpoint,
                 const std::function<void()>& progress);
  /// The row of rheometer.csv at the end.
  [[nodiscard]] std::vector<double> row(const RunPlace& place);

 private:
  void take(const StepReport& report);
  void read();

  ShearCellCase cell_;
  FlowHistory flow_;
  OutputSchedule series_times_;
  Simulation simulation_;
  StressMean stress_;
  std::vector<double> history_;
};

}  // namespace fiberfate
