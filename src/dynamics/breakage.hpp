// Breaks fibers at hinges that are bent too sharply.
#pragma once

#include <vector>

#include "dynamics/break_event.hpp"
#include "dynamics/parameters.hpp"
#include "fibers/state.hpp"

namespace fiberfate {

/// Names a hinge for ever: where it lies on the fiber that was there at the beginning.
struct HingeName {
  std::uint32_t birth_id = 0;
  std::uint32_t birth_node = 0;
};

/// Probability that a hinge of radius R breaks at a check, (3.32), (3.33):
///   x = (R_max − R)/(R_max − R_min) clamped to [0, 1],   P = (e^{m x} − 1)/(e^m − 1)
/// Source: thesis section 3.3.3.
[[nodiscard]] double break_probability(const BreakageParameters& parameters, double radius);

/// Radius at which a hinge of the `strength` law breaks, m: the quantile of P for a number u in (0, 1), so
/// that the share of hinges with a critical radius above R is P(R).
[[nodiscard]] double critical_radius(const BreakageParameters& parameters, double u);

/// Tells whether a hinge breaks at a check. `fixed`: R < R_crit. `probability`: a draw keyed by seed, hinge
/// and check. `strength`: R < the hinge's own critical radius, a draw keyed by seed and hinge alone.
[[nodiscard]] bool breaks(const DynamicsParameters& parameters, const HingeName& hinge, std::int64_t check,
                          double radius);

/// Checks every hinge once and splits each fiber at most at its worst breaking hinge (smallest radius): the
/// break relaxes the others. Counts the check and appends the events, ordered by fiber.
void check_breakage(FiberState& state, const DynamicsParameters& parameters, std::vector<BreakEvent>& events);

}  // namespace fiberfate
