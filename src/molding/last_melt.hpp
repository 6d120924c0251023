// What a filling shows while the last melt comes in and settles: the front is no longer whole, and its few
// free places would ask for more and more pressure on any mesh.
#pragma once

#include <vector>

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"

namespace fiberfate {

/// Pressures of the machine and the melt.
struct ShownPressures {
  explicit ShownPressures(const FillingState& state)
      : at_sprue(state.sprue_pressure), by_node(state.pressure) {}
  double at_sprue;
  std::vector<double> by_node;
};

/// Shows pressures of the step before instead of those of the step that brought in the last melt; at open
/// gates that of the sprue less what their runners take.
void show_again(ShownPressures pressures, const FillingParams& params, FillingState& state);

/// Shows what the machine showed before melt settled, in which it has no part: pressures, rates and the time.
/// Nodes that were reached meanwhile were reached at that time.
void show_again(const FillingState& before, const FillingParams& params, FillingState& state);

}  // namespace fiberfate
