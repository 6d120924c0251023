// Breaks fibers at hinges that are bent too sharply.
#pragma once

#include <vector>

#include "dynamics/break_event.hpp"
#include "dynamics/parameters.hpp"
#include "fibers/state.hpp"

namespace fiberfate {

/// Checks every hinge once and splits each fiber at most at its worst breaking hinge (smallest radius): the
/// break relaxes the others. Counts the check and appends the events, ordered by fiber. Returns the nodes
/// that split_fibers() has doubled.
std::vector<NodeIndex> check_breakage(FiberState& state, const DynamicsParameters& parameters,
                                      std::vector<BreakEvent>& events);

}  // namespace fiberfate
