// What a filling shows while the last melt comes in and settles: the front is no longer whole, and its few
// free places would ask for more and more pressure on any mesh.
#pragma once

#include <vector>

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"

namespace fiberfate {

/// What the machine shows at one moment, and the pressures in the melt.
struct Readings {
  explicit Readings(const FillingState& state)
      : time(state.time),
        volume(state.injected_volume),
        flow_rate(state.flow_rate),
        sprue_pressure(state.sprue_pressure),
        gates(state.gates),
        pressure(state.pressure) {}
  double time;            ///< s
  double volume;          ///< that has come in, m³
  double flow_rate;       ///< m³/s
  double sprue_pressure;  ///< Pa
  std::vector<GateState> gates;
  std::vector<double> pressure;  ///< by node, Pa
};

/// Bounds the pressures of the step that brought in the last melt: they grow from those before it as the
/// volume does, as in a strip, and no faster. At open gates is that of the sprue less what their runners
/// take.
void bound_last_pressures(Readings before, const FillingParams& params, FillingState& state);

/// Shows what the machine showed before melt settled, in which it has no part: pressures, rates and the time.
/// Nodes that were reached meanwhile were reached at that time.
void show_again(Readings before, const FillingParams& params, FillingState& state);

}  // namespace fiberfate
