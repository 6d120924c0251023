// Keeps what a filling shows while the last melt comes in and settles.
#include "molding/last_melt.hpp"

#include <utility>

namespace fiberfate {
namespace {

void show_at_open_gates(const FillingParams& params, FillingState& state) {
  for (std::size_t g = 0; g < state.gates.size(); ++g)
    if (GateState& gate = state.gates[g]; gate.is_open())
      gate.pressure = state.sprue_pressure - params.gates[g].resistance * gate.rate;
}

}  // namespace

void bound_last_pressures(Readings before, const FillingParams& params, FillingState& state) {
  const double growth = state.injected_volume / before.volume;
  if (!(state.sprue_pressure > growth * before.sprue_pressure)) return;
  state.pressure = std::move(before.pressure);
  for (double& pressure : state.pressure) pressure *= growth;
  state.sprue_pressure = growth * before.sprue_pressure;
  show_at_open_gates(params, state);
}

void show_again(Readings before, const FillingParams& params, FillingState& state) {
  state.time = before.time;
  state.pressure = std::move(before.pressure);
  state.sprue_pressure = before.sprue_pressure;
  state.flow_rate = before.flow_rate;
  for (std::size_t g = 0; g < state.gates.size(); ++g) {
    state.gates[g].pressure = before.gates[g].pressure;
    state.gates[g].rate = before.gates[g].rate;
  }
  show_at_open_gates(params, state);
  for (double& time : state.fill_time) time = time > state.time ? state.time : time;
}

}  // namespace fiberfate
