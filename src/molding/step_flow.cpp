// Sorts nodes down the flow and closes the balance of every layer.
#include "molding/step_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

using LayerVolumes = std::array<double, most_half_layers>;

/// Matches the surplus of layers from the mid-plane outwards with the deficit of layers from the wall
/// inwards.
std::size_t match_fountain(LayerVolumes& surplus, std::size_t layers, std::span<LayerTransfer> transfers) {
  std::size_t count = 0, from = 0, to = layers;
  while (true) {
    while (from < layers && !(surplus[from] > 0)) ++from;
    while (to > 0 && !(surplus[to - 1] < 0)) --to;
    if (from >= layers || to == 0 || count == transfers.size()) return count;
    const double volume = std::min(surplus[from], -surplus[to - 1]);
    transfers[count++] = {static_cast<std::uint8_t>(from), static_cast<std::uint8_t>(to - 1), volume};
    // The smaller of the two is used up exactly, so that every turn ends one layer.
    const bool emptied = surplus[from] <= -surplus[to - 1];
    surplus[from] = emptied ? 0 : surplus[from] - volume;
    surplus[to - 1] = emptied ? surplus[to - 1] + volume : 0;
  }
}

/// Hands every layer's surplus to the next one towards the wall; a deficit is filled from there.
std::size_t pass_to_neighbours(const LayerVolumes& surplus, std::size_t layers,
                               std::span<LayerTransfer> transfers) {
  std::size_t count = 0;
  double flux = 0;
  for (std::size_t k = 0; k + 1 < layers; ++k) {
    flux += surplus[k];
    const auto inner = static_cast<std::uint8_t>(k), outer = static_cast<std::uint8_t>(k + 1);
    if (flux > 0) transfers[count++] = {inner, outer, flux};
    if (flux < 0) transfers[count++] = {outer, inner, -flux};
  }
  return count;
}

/// Lets the melt of a node rest: it is sheared no more, and what comes in fills all layers alike.
void let_rest(const GapLayers& layers, std::size_t node, FlowField& field, FillingState& state) {
  const std::size_t count = layers.count();
  field.gradient[node] = Vec2::Zero();
  field.fluidity[node] = 0;
  for (std::size_t k = 0; k < count; ++k) {
    field.shares[node * count + k] = layers.widths()[k];
    field.inverse_viscosity[node * count + k] = 0;
    state.rate[node * count + k] = 0;
  }
}

}  // namespace

void sort_into_levels(const ShellMesh& mesh, StepFlow& step) {
  const std::size_t n = mesh.node_count();
  std::vector<Index> waiting(n, 0);
  for (std::size_t e = 0; e < step.edge_volume.size(); ++e) {
    if (step.edge_volume[e] == 0) continue;
    ++waiting[step.edge_volume[e] > 0 ? mesh.edges()[e].second : mesh.edges()[e].first];
  }
  step.order.clear();
  step.level_begin.assign(1, 0);
  for (std::size_t i = 0; i < n; ++i)
    if (waiting[i] == 0 && step.new_content[i] > 0) step.order.push_back(static_cast<Index>(i));
  while (step.level_begin.back() < step.order.size()) {
    const std::size_t begin = step.level_begin.back(), end = step.order.size();
    step.level_begin.push_back(end);
    for (std::size_t place = begin; place < end; ++place) {
      const std::size_t node = step.order[place];
      for (const ShellNeighbour& to : mesh.neighbours(node))
        if (step.inflow(node, to) < 0 && --waiting[to.node] == 0) step.order.push_back(to.node);
    }
  }
}

void inherit_at_front(const Cavity& cavity, const StepFlow& step, FlowField& field, FillingState& state) {
  const std::size_t count = cavity.layers.count();
  for (const Index index : step.order) {
    const std::size_t node = index;
    if (step.at_front[node] == 0) continue;
    double total = 0;
    LayerVolumes share{}, rate{}, inverse{};
    double fluidity = 0;
    Vec2 gradient = Vec2::Zero();
    for (const ShellNeighbour& from : cavity.mesh.neighbours(node)) {
      const double volume = step.inflow(node, from);
      if (!(volume > 0)) continue;
      total += volume;
      gradient += volume * from.turned(field.gradient[from.node]);
      fluidity += volume * field.fluidity[from.node];
      const std::size_t begin = from.node * count;
      for (std::size_t k = 0; k < count; ++k) {
        share[k] += volume * field.shares[begin + k];
        rate[k] += volume * state.rate[begin + k];
        inverse[k] += volume * field.inverse_viscosity[begin + k];
      }
    }
    if (!(total > 0)) {
      let_rest(cavity.layers, node, field, state);
      continue;
    }
    field.gradient[node] = gradient / total;
    field.fluidity[node] = fluidity / total;
    for (std::size_t k = 0; k < count; ++k) {
      field.shares[node * count + k] = share[k] / total;
      state.rate[node * count + k] = rate[k] / total;
      field.inverse_viscosity[node * count + k] = inverse[k] / total;
    }
  }
}

void split_by_layers(const Cavity& cavity, const FlowField& field, StepFlow& step) {
  const std::size_t count = cavity.layers.count(), n = cavity.mesh.node_count();
  const MeltMotion motion{cavity.layers, step, field};
  step.layer_inflow.resize(n * count);
  step.transfers.resize(n * (count - 1));
  step.transfer_count.assign(n, 0);
  parallel_for(static_cast<std::ptrdiff_t>(step.order.size()), [&](std::ptrdiff_t place) {
    const std::size_t node = step.order[place];
    LayerVolumes in{}, out{};
    for (const ShellNeighbour& other : cavity.mesh.neighbours(node)) {
      const double volume = step.inflow(node, other);
      const std::size_t there = other.node;
      for (std::size_t k = 0; k < count && volume > 0; ++k) in[k] += volume * motion.share(there, node, k);
      for (std::size_t k = 0; k < count && volume < 0; ++k) out[k] -= volume * motion.share(node, there, k);
    }
    const double gate = step.gate_volume[node];
    const double growth = step.new_content[node] - step.content[node];
    LayerVolumes surplus;
    for (std::size_t k = 0; k < count; ++k) {
      (gate > 0 ? in : out)[k] += std::abs(gate) * motion.gate_share(node, k);
      surplus[k] = in[k] - out[k] - growth * cavity.layers.widths()[k];
    }
    const auto transfers = std::span(step.transfers).subspan(node * (count - 1), count - 1);
    const std::size_t made = step.at_front[node] != 0 ? match_fountain(surplus, count, transfers)
                                                      : pass_to_neighbours(surplus, count, transfers);
    for (const LayerTransfer& transfer : transfers.first(made)) in[transfer.to] += transfer.volume;
    std::copy_n(in.begin(), count, step.layer_inflow.begin() + static_cast<std::ptrdiff_t>(node * count));
    step.transfer_count[node] = static_cast<std::uint8_t>(made);
  });
}

}  // namespace fiberfate
