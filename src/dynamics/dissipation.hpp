// Gives the power that the fibers' drag dissipates in the melt.
#pragma once

#include <string_view>

#include "base/vector.hpp"
#include "dynamics/drag_laws/rod_drag.hpp"
#include "fibers/state.hpp"
#include "microstructure/flow.hpp"

namespace fiberfate {

/// Describes how one rod moves against the melt.
struct RodMotion {
  Vec3 direction = Vec3::UnitX();      ///< p
  Vec3 slip = Vec3::Zero();            ///< u(c) − v_c, m/s
  Vec3 spin = Vec3::Zero();            ///< (Omega − omega) across p, rad/s
  Mat3 rate_of_strain = Mat3::Zero();  ///< D of the melt, 1/s
};

/// Gives the power that one rod's drag dissipates beyond what the undisturbed melt does, W:
///   P = F·(u − v) + T·(Omega − omega) + S:D
///     = slip·Z·slip + c_r [|spin|² + 2 Lambda spin·(p × D·p)]
///       + s_0 (p·D·p)² + s_1 |D·p − p p·D·p|² + s_2 [D:D − 2 |D·p|² + (p·D·p)²/2]
/// never negative; s_0, s_1, s_2 are the drag's resistances to strain.
[[nodiscard]] double rod_dissipation(const RodDrag& drag, const RodMotion& motion);

/// Sums it over all rods under a law of drag, with the velocities of the last step, W. Neglects what friction
/// between rods turns into heat (ContactStatistics::friction_power).
[[nodiscard]] double drag_dissipation(const FiberState& state, const Flow& flow, std::string_view law);

}  // namespace fiberfate
