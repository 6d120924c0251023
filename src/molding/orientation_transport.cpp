// Mixes orientations and hands them to the point law in batches.
#include "molding/orientation_transport.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "microstructure/tensor.hpp"
#include "molding/layer_gradients.hpp"

namespace fiberfate {
namespace {

using Components = std::array<double, 6>;

/// Turns a tensor about the normal by the angle of (cos, sin); order 11, 22, 33, 23, 31, 12.
Components turned(const Vec2& turn, const Components& a) {
  const double c = turn[0], s = turn[1];
  return {c * c * a[0] - 2 * c * s * a[5] + s * s * a[1],
          s * s * a[0] + 2 * c * s * a[5] + c * c * a[1],
          a[2],
          s * a[4] + c * a[3],
          c * a[4] - s * a[3],
          c * s * (a[0] - a[1]) + (c * c - s * s) * a[5]};
}

bool fed_by_fountain(const StepFlow& step, std::size_t node, std::size_t layer, std::size_t layers) {
  if (step.at_front[node] == 0) return false;
  const auto transfers = step.transfers_of(node, layers);
  return std::any_of(transfers.begin(), transfers.end(),
                     [&](const LayerTransfer& t) { return t.to == layer; });
}

}  // namespace

/// The points that one thread takes at a time, layer by layer so that neighbours in a pack of eight
/// turn at similar rates.
struct OrientationTransport::Batch {
  bool fed_by_fountain = false;  ///< those at the front that fountain flow feeds, or all others
  std::vector<std::size_t> points;
  std::array<std::vector<double>, 6> second;
  /// Times `share`, so that one duration fits all: rates are proportional to gradients. Only RPR's beta has a
  /// time of its own; with it gradients are as they are and every point has its duration.
  std::array<std::vector<double>, 9> gradient;
  std::vector<double> share;  ///< of the step that melt stays in the layer
  std::vector<LayerGradients> of_node;
};

OrientationTransport::OrientationTransport(const ShellMesh& mesh, const FillingParams& params,
                                           const GapLayers& layers)
    : mesh_(&mesh), params_(&params), layers_(&layers) {
  if (params.fibers.orientation) law_.emplace(*params.fibers.orientation);
}

Components OrientationTransport::inlet(std::size_t node, int gate, const FlowField& field) const {
  const std::size_t g = gate;
  const MoldingFibers& fibers = params_->fibers;
  const bool own = g < fibers.gate_inlets.size() && fibers.gate_inlets[g];
  const InletFibers& inlet = own ? *fibers.gate_inlets[g] : fibers.inlet;
  Mat3 local;
  if (inlet.axes == InletAxes::part) {
    local = mesh_->frame(node).transpose() * inlet.orientation * mesh_->frame(node);
  } else {
    const Vec2 down = -field.gradient[node];
    const Vec2 flow = down.norm() > 0 ? Vec2(down.normalized()) : Vec2(1, 0);
    Mat3 axes;
    axes << flow[0], -flow[1], 0, flow[1], flow[0], 0, 0, 0, 1;
    local = axes * inlet.orientation * axes.transpose();
  }
  return {local(0, 0), local(1, 1), local(2, 2), 0, 0, local(0, 1)};
}

Components OrientationTransport::mixed(LayerOfNode at, const MeltMotion& motion,
                                       const FillingState& state) const {
  const auto [node, layer] = at;
  const StepFlow& step = motion.step;
  const std::size_t count = layers_->count(), point = node * count + layer;
  const double content = step.content[node] * layers_->widths()[layer];
  const auto second = [&](std::size_t p) {
    Components a;
    for (std::size_t m = 0; m < 6; ++m) a[m] = state.orientation[m][p];
    return a;
  };
  double total = content;
  Components mixed;
  for (std::size_t m = 0; m < 6; ++m) mixed[m] = content * state.orientation[m][point];
  const auto take = [&](const Components& a, double volume) {
    for (std::size_t m = 0; m < 6; ++m) mixed[m] += volume * a[m];
    total += volume;
  };
  for (const ShellNeighbour& from : mesh_->neighbours(node)) {
    const double volume = step.inflow(node, from);
    if (!(volume > 0)) continue;
    const std::size_t there = from.node;
    const Components a = second(there * count + layer);
    take(from.turn[0] < 1 ? turned(from.turn, a) : a, volume * motion.share(there, node, layer));
  }
  const double gate = step.gate_volume[node];
  if (gate > 0) take(inlet(node, step.gate[node], motion.field), gate * motion.gate_share(node, layer));
  for (const LayerTransfer& t : step.transfers_of(node, count))
    if (t.to == layer && (step.content[node] > 0 || step.at_front[node] != 0))
      take(second(node * count + t.from), t.volume);
  for (double& component : mixed) component /= total;
  return mixed;
}

void OrientationTransport::load(std::span<const Index> nodes, const MeltMotion& motion,
                                const FillingState& state, Batch& batch) const {
  const StepFlow& step = motion.step;
  const std::size_t count = layers_->count();
  const bool scaled = params_->fibers.orientation->constants.beta == 0;
  batch.points.clear();
  batch.share.clear();
  for (auto& component : batch.second) component.clear();
  for (auto& component : batch.gradient) component.clear();
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const std::size_t node = nodes[n];
      const std::size_t point = node * count + k;
      const double content = step.content[node] * layers_->widths()[k];
      const double total = content + step.layer_inflow[point];
      if (!(total > 0) || fed_by_fountain(step, node, k, count) != batch.fed_by_fountain) continue;
      const Components a = mixed({node, k}, motion, state);
      const double share = content / total;
      batch.points.push_back(point);
      batch.share.push_back(share);
      for (std::size_t m = 0; m < 6; ++m) batch.second[m].push_back(a[m]);
      for (std::size_t m = 0; m < 9; ++m)
        batch.gradient[m].push_back((scaled ? share : 1) * batch.of_node[n][m][k]);
    }
}

void OrientationTransport::turn_and_store(double duration, Batch& batch, FillingState& state) const {
  OrientationPoints points;
  points.count = batch.points.size();
  for (std::size_t m = 0; m < 6; ++m) {
    points.second[m] = batch.second[m].data();
    points.result[m] = batch.second[m].data();
  }
  for (std::size_t m = 0; m < 9; ++m) points.gradient[m] = batch.gradient[m].data();
  const double tolerance = params_->numerics.orientation_tolerance;
  if (params_->fibers.orientation->constants.beta == 0) {
    law_->advance(points, {duration, tolerance});
  } else {
    OrientationPoints one = points;
    one.count = 1;
    for (std::size_t p = 0; p < points.count; ++p) {
      for (std::size_t m = 0; m < 6; ++m) one.second[m] = one.result[m] = &batch.second[m][p];
      for (std::size_t m = 0; m < 9; ++m) one.gradient[m] = &batch.gradient[m][p];
      law_->advance(one, {duration * batch.share[p], tolerance});
    }
  }
  for (std::size_t p = 0; p < batch.points.size(); ++p)
    for (std::size_t m = 0; m < 6; ++m) state.orientation[m][batch.points[p]] = batch.second[m][p];
}

void OrientationTransport::advance(std::span<const Index> nodes, const MeltMotion& motion,
                                   FillingState& state) const {
  if (!law_) return;
  Batch batch;
  batch.of_node.resize(nodes.size());
  bool fountain = false;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const std::size_t node = nodes[n];
    find_layer_gradients(*mesh_, motion, node, batch.of_node[n]);
    fountain = fountain || motion.step.at_front[node] != 0;
  }
  for (const bool fed : {false, true}) {
    if (fed && !fountain) return;
    batch.fed_by_fountain = fed;
    load(nodes, motion, state, batch);
    turn_and_store(motion.step.duration, batch, state);
  }
}

}  // namespace fiberfate
