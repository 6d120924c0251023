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
  for (const Gate& gate : params.gates) {
    nodes_.push_back(nodes_of(gate, mesh));
    const auto& sensor = gate.opens.sensor ? gate.opens.sensor : gate.closes.sensor;
    if (sensor) {
      sensors_.push_back({static_cast<Index>(mesh.nearest_node(*sensor))});
    } else {
      sensors_.push_back(nodes_.back());
    }
  }
}

bool GateControl::fires(const Trigger& trigger, const GateState& gate, const FillingState& state) const {
  const double fraction = state.injected_volume / mesh_->total_volume();
  switch (trigger.kind) {
    case TriggerKind::start:
      return true;
    case TriggerKind::filled_fraction:
      return fraction >= trigger.value - round_off;
    case TriggerKind::time:
      return state.time >= trigger.value * (1 - round_off);
    case TriggerKind::arrival:
      return state.time >=
             (gate.arrival_time + trigger.value) * (1 - round_off);  // false before arrival (NaN)
    case TriggerKind::never:
      break;
  }
  return false;
}

bool GateControl::update(FillingState& state) const {
  bool changed = false;
  const double fraction = state.injected_volume / mesh_->total_volume();
  for (std::size_t g = 0; g < nodes_.size(); ++g) {
    GateState& gate = state.gates[g];
    const auto full = [&](Index node) { return state.filled[node] >= 1; };
    if (std::isnan(gate.arrival_time) && std::all_of(sensors_[g].begin(), sensors_[g].end(), full))
      gate.arrival_time = state.time;
    const auto enter = [&](GatePhase phase, FillingEventKind kind) {
      gate.phase = phase;
      state.events.push_back({state.time, fraction, kind, static_cast<int>(g)});
      changed = true;
    };
    if (gate.phase == GatePhase::closed_yet && fires(params_->gates[g].opens, gate, state))
      enter(GatePhase::open, FillingEventKind::gate_opened);
    if (gate.phase == GatePhase::open && fires(params_->gates[g].closes, gate, state)) {
      enter(GatePhase::closed_again, FillingEventKind::gate_closed);
      gate.rate = 0;
    }
  }
  return changed;
}

std::vector<GateLink> GateControl::links(const FillingState& state, std::vector<std::size_t>& open) const {
  std::vector<GateLink> links;
  open.clear();
  for (std::size_t g = 0; g < nodes_.size(); ++g) {
    if (state.gates[g].phase != GatePhase::open) continue;
    open.push_back(g);
    links.push_back({nodes_[g], params_->gates[g].resistance});
  }
  return links;
}

double GateControl::next_fraction(const FillingState& state) const {
  const double fraction = state.injected_volume / mesh_->total_volume();
  double next = std::numeric_limits<double>::infinity();
  for (const Gate& gate : params_->gates)
    for (const Trigger* trigger : {&gate.opens, &gate.closes})
      if (trigger->kind == TriggerKind::filled_fraction && trigger->value > fraction + round_off)
        next = std::min(next, trigger->value);
  return next;
}

double GateControl::next_time(const FillingState& state) const {
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < nodes_.size(); ++g)
    for (const Trigger* trigger : {&params_->gates[g].opens, &params_->gates[g].closes}) {
      double due = std::numeric_limits<double>::infinity();
      if (trigger->kind == TriggerKind::time) due = trigger->value;
      const double arrival = state.gates[g].arrival_time;
      if (trigger->kind == TriggerKind::arrival && !std::isnan(arrival)) due = arrival + trigger->value;
      if (due > state.time * (1 + round_off)) next = std::min(next, due);
    }
  return next;
}

}  // namespace fiberfate
