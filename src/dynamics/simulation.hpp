// Moves a population of fibers through time.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/timer.hpp"
#include "dynamics/break_event.hpp"
#include "dynamics/parameters.hpp"
#include "dynamics/particle_stress.hpp"
#include "fibers/state.hpp"
#include "microstructure/flow_history.hpp"

namespace fiberfate {

/// What held the size of a step down.
enum class StepLimit { control, tolerance, strain, maximum, event };
[[nodiscard]] const char* name(StepLimit limit);

/// Summarises the contacts at the present positions.
struct ContactStatistics {
  std::int64_t contacts = 0;      ///< pairs of rods with d < d_cut a that carry a normal force
  double contacts_per_fiber = 0;  ///< 2 contacts / fibers
  double max_overlap = 0;         ///< largest (a_i + a_j − d)/a, in radii; 0 when none
  double mean_overlap = 0;        ///< mean over contacts of the same
  double largest_force = 0;       ///< N
};

/// What one call of advance() did.
struct StepReport {
  double step_size = 0;  ///< s
  StepLimit limit = StepLimit::control;
  int rejections = 0;  ///< trial steps thrown away
  /// Of the step, where it was asked for (watch_stress).
  std::optional<ParticleStress> stress = {};
};

/// Steps a state: neighbours, loads, solve, trial, accept or shrink, breakage (docs/theory/particles.md).
/// The state alone determines the future: a simulation made from a saved state continues bitwise, with any
/// number of threads.
class Simulation {
 public:
  /// Takes the parameters, the flow and the state to start from; raises InputError when they cannot belong
  /// together.
  Simulation(const DynamicsParameters& parameters, FlowHistory flow, FiberState state);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Makes one accepted step, cut so as not to pass `until` (later than now; may be infinite), a change of
  /// the flow or a breakage check. Raises InputError for a time that is not ahead, SimulationFailure when no
  /// step above the minimum is acceptable or a position is not finite.
  StepReport advance(double until);

  /// Lets every so many steps, counted from the state's first, report their particle stress, and those that
  /// reach the time asked for; 0: none does.
  void watch_stress(std::int64_t steps);

  [[nodiscard]] const FiberState& state() const;
  /// Hands over the breaks since the last call, in order of time, birth id and node.
  [[nodiscard]] std::vector<BreakEvent> take_break_events();
  /// Measures the contacts at the present positions (a pass over the neighbour list).
  [[nodiscard]] ContactStatistics contact_statistics();
  [[nodiscard]] PhaseTimes& times();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace fiberfate
