// Advances the positions of fibers by one step.
#pragma once

#include "fibers/state.hpp"
#include "microstructure/flow.hpp"

namespace fiberfate {

/// Extrapolates every node to the middle of the step with its last velocity: x + (step/2)(kappa·x + w_last).
void extrapolate_to_middle(const FiberState& state, const Flow& flow, double step,
                           IndexedSpan<NodeIndex, Vec3> middle);

/// Moves every node, x ← exp(kappa step)·x + step (w + (step/2) kappa·w_last), restores every rod's length
/// and then the fiber's centroid (restoring from one end would drift), carries the cell, and makes w the
/// state's velocity. `travelled` receives, for every rod, the larger displacement of its nodes relative to
/// the fluid, m. Advances the time.
void move_fibers(FiberState& state, const Flow& flow, double step,
                 IndexedSpan<NodeIndex, const Vec3> relative_velocity,
                 IndexedSpan<RodIndex, double> travelled);

/// Local error of the step in radii, (step/2) rms |w − w_last| / a; see step_control.hpp. Infinite when a
/// velocity is not finite. `by_fiber` is scratch that holds the fibers' shares.
[[nodiscard]] double displacement_error(const FiberState& state, double step,
                                        IndexedVector<FiberIndex, double>& by_fiber,
                                        IndexedSpan<NodeIndex, const Vec3> relative_velocity);

/// Makes the cell compact again and brings strayed fibers back into it; tells whether anything was done,
/// after which images are no longer those they were. Depends on the state alone: restarts change nothing.
[[nodiscard]] bool tidy_cell(FiberState& state);

/// Ends the exemption from contact of broken ends whose axes are further apart than `range`.
void release_separated_ends(FiberState& state, double range);

}  // namespace fiberfate
