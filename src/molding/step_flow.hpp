// What flows where in one step: between nodes, through gates, across the gap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "molding/filling_state.hpp"
#include "molding/flow_field.hpp"
#include "molding/gap_layers.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Carries melt from layer to layer of one node.
struct LayerTransfer {
  std::uint8_t from = 0;
  std::uint8_t to = 0;
  double volume = 0;  ///< m³, positive
};

/// One layer of one node.
struct LayerOfNode {
  std::size_t node, layer;
};

/// Volumes (m³) that move in one step. Every field that rides on the melt moves by them: a layer of a
/// node then holds, mixed,
///   (content value + sum of inflow · value of its origin)/(content + inflow),
/// with the new values of the origins: implicit, first-order upwind, no limit to the step. Origins are found
/// before, since melt flows down the pressure: `levels` of nodes that do not feed each other.
struct StepFlow {
  double duration = 0;                       ///< s
  std::vector<double> edge_volume;           ///< by edge, from first to second
  std::vector<double> gate_volume;           ///< by node, that comes in through a gate (out, if negative)
  std::vector<int> gate;                     ///< by node: number of the gate that feeds it, or -1
  std::vector<char> at_front;                ///< by node: was not full before the step
  std::vector<double> content;               ///< by node, before the step
  std::vector<double> new_content;           ///< by node, after the step
  std::vector<Index> order;                  ///< nodes that hold melt after the step, level by level
  std::vector<std::size_t> level_begin;      ///< in `order`; one more than there are levels
  std::vector<double> layer_inflow;          ///< by point: all that comes in
  std::vector<LayerTransfer> transfers;      ///< [node][layers - 1]
  std::vector<std::uint8_t> transfer_count;  ///< by node

  /// What comes into `node` from a neighbour; negative when it goes there.
  [[nodiscard]] double inflow(std::size_t node, const ShellNeighbour& from) const {
    const double volume = edge_volume[from.edge];
    return static_cast<Index>(node) < from.node ? -volume : volume;
  }
  [[nodiscard]] std::span<const LayerTransfer> transfers_of(std::size_t node, std::size_t layers) const {
    return std::span(transfers).subspan(node * (layers - 1), transfer_count[node]);
  }
};

/// The space that fills, and the layers that half of its gap has everywhere.
struct Cavity {
  const ShellMesh& mesh;
  const GapLayers& layers;
};

/// One step of the melt, as all that rides on it sees it.
struct MeltMotion {
  const GapLayers& layers;
  const StepFlow& step;
  const FlowField& field;
  std::span<const double> stretching =
      {};  ///< 1 + R (D:A4:D)/(D:D) by point; empty where fibers do not count

  /// The share of what flows between two nodes that is in layer k: the mean of both where both are full,
  /// else that of the one it comes from (the front inherits its shares).
  [[nodiscard]] double share(std::size_t from, std::size_t to, std::size_t k) const {
    const double there = field.shares[from * layers.count() + k];
    if (step.at_front[from] != 0 || step.at_front[to] != 0) return there;
    return 0.5 * (there + field.shares[to * layers.count() + k]);
  }
  /// The share of what a gate brings into a node that is in layer k.
  [[nodiscard]] double gate_share(std::size_t node, std::size_t k) const {
    return step.at_front[node] != 0 ? layers.widths()[k] : field.shares[node * layers.count() + k];
  }
};

/// Sorts the nodes into levels, down the flow.
void sort_into_levels(const ShellMesh& mesh, StepFlow& step);

/// Gives nodes of the front the flow shares, shear rates, viscosities and pressure gradient of the melt that
/// comes in. Where none comes from another node the melt rests: nothing shears it.
void inherit_at_front(const Cavity& cavity, const StepFlow& step, FlowField& field, FillingState& state);

/// Splits the step's volumes by layers and closes each layer's balance by flow across the gap: from layer to
/// neighbouring layer behind the front; at the front as fountain flow. There the layers of the core, faster
/// than the front, bring more than they need, and those at the wall less; a stream line leaves the core and
/// reaches the wall at the same stream function, so the mid-plane's surplus goes to the wall first.
void split_by_layers(const Cavity& cavity, const FlowField& field, StepFlow& step);

}  // namespace fiberfate
