// Steps a simulation until it is told to stop, and calls for what is due on the way.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "dynamics/simulation.hpp"
#include "results/run_types.hpp"

namespace fiberfate {

/// When to stop.
struct RunLimits {
  double end = 0;                        ///< simulated time, s
  StopReason at_end = StopReason::done;  ///< what reaching it means
  std::optional<std::int64_t> steps;     ///< most steps to make
  double checkpoint_interval = 300;      ///< wall time between checkpoints, s
  std::function<bool()> stop_requested = {};
};

/// What is done between steps.
struct RunActions {
  std::function<double(double)> next_output;  ///< first time after the given one at which output is due, s
  std::function<void(const StepReport&)> after_step;  ///< collects what the step produced
  std::function<void()> output;                       ///< writes what is due at the present time
  std::function<void()> checkpoint;                   ///< saves everything
  std::function<void(const StepReport&)> progress;    ///< shows that the run is alive
};

/// Counts what a run did in this process.
struct RunOutcome {
  StopReason reason = StopReason::done;
  std::int64_t rod_steps = 0;
  std::int64_t rejections = 0;
  double stepping_seconds = 0;  ///< wall time inside the steps: everything but output

  /// Rod-steps per second of stepping.
  [[nodiscard]] double speed() const {
    return stepping_seconds > 0 ? static_cast<double>(rod_steps) / stepping_seconds : 0;
  }
};

/// Runs; output times are met exactly. A last checkpoint is left to the caller.
[[nodiscard]] RunOutcome run_loop(Simulation& simulation, const RunLimits& limits, const RunActions& actions);

}  // namespace fiberfate
