// Steps a simulation until it is told to stop.
#include "studies/shear_cell/run_loop.hpp"

#include <algorithm>

namespace fiberfate {
namespace {

std::optional<StopReason> reason_to_stop(const FiberState& state, const RunLimits& limits,
                                         std::int64_t first_step) {
  if (state.time >= limits.end) return limits.at_end;
  if (limits.stop_requested && limits.stop_requested()) return StopReason::signal;
  if (limits.steps && state.step - first_step >= *limits.steps) return StopReason::steps_reached;
  return std::nullopt;
}

}  // namespace

RunOutcome run_loop(Simulation& simulation, const RunLimits& limits, const RunActions& actions) {
  const FiberState& state = simulation.state();
  const std::int64_t first_step = state.step;
  const std::int64_t first_rod_step = state.rod_steps;
  RunOutcome outcome;
  double last_checkpoint = wall_seconds();
  double due = std::min(actions.next_output(state.time), limits.end);
  // A resumed run meets the outputs after its time. One that is due within round-off of it (a flow may change
  // there) comes first, or it would be lost.
  const auto can_be_resumed = [&] { return std::min(actions.next_output(state.time), limits.end) == due; };
  for (;;) {
    const auto reason = reason_to_stop(state, limits, first_step);
    if (reason && can_be_resumed()) {
      outcome.reason = *reason;
      outcome.rod_steps = state.rod_steps - first_rod_step;
      return outcome;
    }
    const double before = wall_seconds();
    const StepReport report = simulation.advance(due);
    outcome.stepping_seconds += wall_seconds() - before;
    outcome.rejections += report.rejections;
    actions.after_step(report);
    if (state.time >= due) {
      actions.output();
      due = std::min(actions.next_output(state.time), limits.end);
    }
    if (wall_seconds() - last_checkpoint >= limits.checkpoint_interval && can_be_resumed()) {
      actions.checkpoint();
      last_checkpoint = wall_seconds();
    }
    actions.progress(report);
  }
}

}  // namespace fiberfate
