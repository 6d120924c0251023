// Chooses the size of the next time step.
#pragma once

#include "dynamics/parameters.hpp"
#include "dynamics/simulation.hpp"
#include "microstructure/flow.hpp"

namespace fiberfate {

/// A step size and what limited it.
struct StepChoice {
  double size = 0;  ///< s
  StepLimit limit = StepLimit::control;
};

// Steps are chosen from an estimate of the local error.
//
// Positions are advanced with second order, from the geometry at mid-step extrapolated with the last
// velocity; the error estimate is the displacement by which the new velocity departs from the last one,
//   e = (step/2) rms |w − w_last| / a    (rms over nodes, in radii)
// and a step is accepted when e <= 2 tolerance. In smooth motion it falls with the square of the step.

/// Proposes the first trial of a step: the state's own proposal, bounded by strain, maximum and the event
/// ahead. The time to the event is divided evenly, so that no sliver remains.
[[nodiscard]] StepChoice propose_step(const StepParameters& parameters, double proposal, const Flow& flow,
                                      double to_event);

/// Whether a trial step with this error is to be kept.
[[nodiscard]] bool is_acceptable(const StepParameters& parameters, double error);

/// Returns the size for another trial after a rejected one, s.
[[nodiscard]] double shrunk_step(const StepParameters& parameters, double step, double error);

/// Returns the proposal for the step after an accepted one, s.
[[nodiscard]] double next_proposal(const StepParameters& parameters, const StepChoice& accepted,
                                   double proposal, double error);

}  // namespace fiberfate
