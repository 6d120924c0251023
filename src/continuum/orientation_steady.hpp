// The orientation that no longer changes in a constant flow, found directly.
#pragma once

#include "base/vector.hpp"
#include "continuum/orientation_model.hpp"

namespace fiberfate {

/// A steady state and how it is approached.
struct SteadyOrientation {
  Mat3 second = Mat3::Zero();
  double decay_rate = 0;  ///< by which the slowest disturbance dies out, exp(-decay_rate t), 1/s
  double residual = 0;    ///< Frobenius norm of DA/Dt that round-off leaves, 1/s
};

/// Finds the stable state with DA/Dt = 0 in a constant velocity gradient (1/s), for any diffusion,
/// retardation and closure.
///
/// Newton's method in the five components that the unit trace leaves, started as an implicit Euler method
/// whose time step grows as the rate falls (pseudo-transient continuation; Kelley, Keyes, SIAM J. Numer.
/// Anal. 35, 508 (1998)), from seven states: isotropic, and aligned and planar along the axes of D.
/// Retardations do not move steady states and are left out of the search; they enter the decay rate. Raises
/// InputError where nothing deforms or the retardation holds the principal values, and SimulationFailure,
/// which says what holds instead, where no state is found, where those found are impossible, unstable or not
/// isolated (without diffusion fibers align for ever, or turn; a closure may hide that), or where several are
/// stable and the start decides.
[[nodiscard]] SteadyOrientation steady_orientation(const OrientationModel& model, const Mat3& gradient);

}  // namespace fiberfate
