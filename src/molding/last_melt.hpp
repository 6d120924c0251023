// What a filling shows while the last melt comes in and settles: the front is no longer whole, and its few
// free places would ask for more and more pressure on any mesh.
#pragma once

#include <vector>

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"

namespace fiberfate {

/// Pressures of the machine and the melt, and the volume that was in.
struct ShownPressures {
  explicit ShownPressures(const FillingState& state)
      : at_sprue(state.sprue_pressure), volume(state.injected_volume), by_node(state.pressure) {}
  double at_sprue;  ///< Pa
  double volume;    ///< m³
  std::vector<double> by_node;
};

/// Bounds the pressures of the step that brought in the last melt: they grow from those before it as the
/// volume does, as in a strip, and no faster. At open gates is that of the sprue less what their runners
/// take.
void bound_last_pressures(ShownPressures before, const FillingParams& params, FillingState& state);

/// Shows what the machine showed before melt settled, in which it has no part: pressures, rates and the time.
/// Nodes that were reached meanwhile were reached at that time.
void show_again(const FillingState& before, const FillingParams& params, FillingState& state);

}  // namespace fiberfate
