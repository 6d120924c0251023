// Runs the cell of one point and replica in memory.
#include "studies/rheometer/cell_run.hpp"

#include <utility>

namespace fiberfate {

CellRun::CellRun(ShearCellCase cell, FiberState state, const RunNotes& notes)
    : cell_(std::move(cell)),
      flow_(flow_history(cell_.flow)),
      series_times_{series_interval(cell_.run, cell_.output), cell_.output.times},
      simulation_(dynamics_parameters(cell_), flow_, std::move(state)),
      stress_(StressMean::from(notes.stress)),
      history_(notes.history) {
  simulation_.watch_stress(cell_.output.stress_steps);
}

RunOutcome CellRun::run(RunLimits limits, const std::function<void()>& checkpoint,
                        const std::function<void()>& progress) {
  limits.end = end();
  RunActions actions;
  actions.next_output = [this](double time) { return series_times_.next(time); };
  actions.after_step = [this](const StepReport& report) { take(report); };
  actions.output = [this] { read(); };
  actions.checkpoint = checkpoint;
  actions.progress = [&progress](const StepReport&) { progress(); };
  return run_loop(simulation_, limits, actions);
}

std::vector<double> CellRun::row(const RunPlace& place) {
  return reading_row(place, moment_of(cell_, flow_, simulation_), history_);
}

void CellRun::take(const StepReport& report) {
  if (report.stress) stress_.add(*report.stress, report.step_size);
  static_cast<void>(simulation_.take_break_events());
}

/// Adds a row of what is averaged.
void CellRun::read() {
  CellMoment now = moment_of(cell_, flow_, simulation_);
  if (!stress_.is_empty()) now.stress = stress_.mean();
  stress_ = {};
  history_.push_back(now.state.time);
  for (const double value : measure(averaged_observables(), now)) history_.push_back(value);
}

}  // namespace fiberfate
