// Compares triggers with the state of the filling.
#include "molding/gate_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "molding/gate_nodes.hpp"

namespace fiberfate {
namespace {

/// Events are hit exactly but for round-off.
constexpr double round_off = 1e-12;

}  // namespace

GateControl::GateControl(const ShellMesh& mesh, const FillingParams& params)
    : mesh_(&mesh), params_(&params) {
  for (const Gate& gate : params.gates) nodes_.push_back(nodes_of(gate, mesh));
  for (const Sensor& sensor : params.sensors)
    sensors_.push_back(static_cast<Index>(mesh.nearest_node(sensor.position)));
}

const Trigger* GateControl::next_trigger(std::size_t gate, const FillingState& state) const {
  const std::size_t moves = state.gates[gate].moves;
  const std::vector<OpenInterval>& intervals = params_->gates[gate].intervals;
  if (moves / 2 >= intervals.size()) return nullptr;
  return moves % 2 == 0 ? &intervals[moves / 2].opens : &intervals[moves / 2].closes;
}

double GateControl::arrival(const Trigger& trigger, std::size_t gate, const FillingState& state) const {
  if (trigger.sensor == own_gate) return state.gates[gate].arrival_time;
  return state.sensor_arrivals[trigger.sensor];
}

bool GateControl::fires(const Trigger& trigger, std::size_t gate, const FillingState& state) const {
  const double fraction = state.injected_volume / mesh_->total_volume();
  switch (trigger.kind) {
    case TriggerKind::start:
      return true;
    case TriggerKind::filled_fraction:
      return fraction >= trigger.value - round_off;
    case TriggerKind::time:
      return state.time >= trigger.value * (1 - round_off);
    case TriggerKind::arrival:  // false before arrival (NaN)
      return state.time >= (arrival(trigger, gate, state) + trigger.value) * (1 - round_off);
    case TriggerKind::never:
      break;
  }
  return false;
}

bool GateControl::is_full(std::size_t gate, const FillingState& state) const {
  return std::all_of(nodes_[gate].begin(), nodes_[gate].end(),
                     [&](Index node) { return state.filled[node] >= 1; });
}

void GateControl::note_arrivals(FillingState& state) const {
  for (std::size_t g = 0; g < nodes_.size(); ++g)
    if (std::isnan(state.gates[g].arrival_time) && is_full(g, state))
      state.gates[g].arrival_time = state.time;
  for (std::size_t s = 0; s < sensors_.size(); ++s)
    if (std::isnan(state.sensor_arrivals[s]) && state.filled[sensors_[s]] >= 1)
      state.sensor_arrivals[s] = state.time;
}

void GateControl::update(FillingState& state) const {
  const double fraction = state.injected_volume / mesh_->total_volume();
  note_arrivals(state);
  for (std::size_t g = 0; g < nodes_.size(); ++g) {
    GateState& gate = state.gates[g];
    for (const Trigger* next = next_trigger(g, state); next != nullptr && fires(*next, g, state);
         next = next_trigger(g, state)) {
      ++gate.moves;
      state.events.push_back({state.time, fraction,
                              gate.is_open() ? FillingEventKind::gate_opened : FillingEventKind::gate_closed,
                              static_cast<int>(g)});
    }
    if (!gate.is_open()) gate.rate = 0;
  }
}

std::vector<GateLink> GateControl::links(const FillingState& state, std::vector<std::size_t>& open) const {
  std::vector<GateLink> links;
  open.clear();
  for (std::size_t g = 0; g < nodes_.size(); ++g) {
    if (!state.gates[g].is_open()) continue;
    open.push_back(g);
    links.push_back(
        {nodes_[g], params_->gates[g].resistance, is_full(g, state) ? GateFront::passed : GateFront::inside});
  }
  return links;
}

bool GateControl::fills(std::size_t gate, RunnerKind runner, const FillingState& state) const {
  const bool resisting = params_->gates[gate].resistance > 0;
  return state.gates[gate].is_open() && resisting == (runner == RunnerKind::resisting) &&
         !is_full(gate, state);
}

double GateControl::lacking(std::size_t gate, const FillingState& state) const {
  double volume = 0;
  for (const Index node : nodes_[gate]) volume += mesh_->volume(node) * (1 - state.filled[node]);
  return volume;
}

double GateControl::lacking(RunnerKind runners, const FillingState& state) const {
  double volume = 0;
  for (std::size_t g = 0; g < nodes_.size(); ++g)
    if (fills(g, runners, state)) volume += lacking(g, state);
  return volume;
}

double GateControl::time_to_fill(const FillingState& state, double sprue_pressure) const {
  double time = std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < nodes_.size() && sprue_pressure > 0; ++g)
    if (fills(g, RunnerKind::resisting, state))
      time = std::min(time, lacking(g, state) * params_->gates[g].resistance / sprue_pressure);
  return time;
}

void GateControl::note_fed_nodes(const FillingState& state, std::vector<int>& gate_of) const {
  gate_of.assign(mesh_->node_count(), -1);
  for (std::size_t g = 0; g < nodes_.size(); ++g) {
    if (!state.gates[g].is_open()) continue;
    const bool full = is_full(g, state);
    for (const Index node : nodes_[g])
      if (full || state.filled[node] < 1) gate_of[node] = static_cast<int>(g);
  }
}

void GateControl::fill(std::size_t gate, double share, const FillingState& state,
                       std::vector<double>& gate_volume) const {
  for (const Index node : nodes_[gate])
    if (state.filled[node] < 1) gate_volume[node] = share * mesh_->volume(node) * (1 - state.filled[node]);
}

void GateControl::fill_at_sprue(double share, const FillingState& state,
                                std::vector<double>& gate_volume) const {
  for (std::size_t g = 0; g < nodes_.size(); ++g)
    if (fills(g, RunnerKind::none, state)) fill(g, share, state, gate_volume);
}

void GateControl::fill_through_runners(double sprue_pressure, double duration, const FillingState& state,
                                       std::vector<double>& gate_volume) const {
  for (std::size_t g = 0; g < nodes_.size(); ++g) {
    if (!fills(g, RunnerKind::resisting, state)) continue;
    const double share = sprue_pressure / params_->gates[g].resistance * duration / lacking(g, state);
    fill(g, share < 1 - round_off ? share : 1, state, gate_volume);
  }
}

double GateControl::next_fraction(const FillingState& state) const {
  const double fraction = state.injected_volume / mesh_->total_volume();
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < nodes_.size(); ++g) {
    const Trigger* trigger = next_trigger(g, state);
    if (trigger != nullptr && trigger->kind == TriggerKind::filled_fraction &&
        trigger->value > fraction + round_off)
      next = std::min(next, trigger->value);
  }
  return next;
}

double GateControl::next_time(const FillingState& state) const {
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < nodes_.size(); ++g) {
    const Trigger* trigger = next_trigger(g, state);
    if (trigger == nullptr) continue;
    double due = std::numeric_limits<double>::infinity();
    if (trigger->kind == TriggerKind::time) due = trigger->value;
    if (trigger->kind == TriggerKind::arrival) due = arrival(*trigger, g, state) + trigger->value;
    if (due > state.time * (1 + round_off)) next = std::min(next, due);  // false before arrival (NaN)
  }
  return next;
}

}  // namespace fiberfate
