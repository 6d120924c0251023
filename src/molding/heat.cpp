// Assembles and solves the heat balance of the layers of every node.
#include "molding/heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "molding/gap_flow.hpp"

namespace fiberfate {
namespace {

/// Rise of the temperature by flow beyond which a state is none of any melt, K. A pressure of 1 GPa heats by
/// 500 K.
constexpr double bearable_rise = 1000;

/// The equations of one node's layers; m(row, column) couples layers that exchange melt or heat.
struct LayerSystem {
  std::array<double, most_half_layers * most_half_layers> matrix;
  std::array<double, most_half_layers> right;
  std::size_t count;

  explicit LayerSystem(std::size_t layers) : count(layers) {
    std::fill_n(matrix.begin(), count * count, 0.0);
    std::fill_n(right.begin(), count, 0.0);
  }
  double& m(std::size_t row, std::size_t column) { return matrix[row * count + column]; }

  /// Eliminates in place without exchange of rows: the matrix is diagonally dominant. `reach` is how far
  /// from the diagonal entries stand.
  void solve(std::size_t reach) {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t row = i + 1; row < std::min(count, i + 1 + reach); ++row) {
        if (m(row, i) == 0) continue;
        const double factor = m(row, i) / m(i, i);
        for (std::size_t j = i + 1; j < std::min(count, i + 1 + reach); ++j) m(row, j) -= factor * m(i, j);
        right[row] -= factor * right[i];
      }
    for (std::size_t i = count; i-- > 0;) {
      for (std::size_t j = i + 1; j < std::min(count, i + 1 + reach); ++j) right[i] -= m(i, j) * right[j];
      right[i] /= m(i, i);
    }
  }
};

}  // namespace

void HeatTransport::collect_dissipation(const StepFlow& step, const FlowField& field) {
  dissipated_.assign(mesh_->node_count(), 0);
  for (std::size_t e = 0; e < mesh_->edges().size(); ++e) {
    const auto [a, b] = mesh_->edges()[e];
    if (field.wet[a] == 0 && field.wet[b] == 0) continue;
    const double heat = field.edge_flux[e] * (field.pressure[a] - field.pressure[b]) * step.duration;
    // On the way to the front half an edge belongs to the wet node, the rest to the other.
    const double share_a = field.wet[b] == 0 ? 0.5 * field.front_factor[b] : 0.5;
    const double share = field.wet[a] == 0 ? 1 - 0.5 * field.front_factor[a] : share_a;
    dissipated_[a] += share * heat;
    dissipated_[b] += (1 - share) * heat;
  }
}

void HeatTransport::advance_node(std::size_t node, const MeltMotion& motion, FillingState& state) {
  const StepFlow& step = motion.step;
  const std::size_t count = layers_->count(), begin = node * count;
  const MoldingMaterial& material = params_->material;
  const double capacity = material.density * material.heat_capacity;
  const double mold = params_->process.mold_temperature, inlet = params_->process.inlet_temperature;
  LayerSystem system(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double content = step.content[node] * layers_->widths()[k];
    system.m(k, k) = content + step.layer_inflow[begin + k];
    system.right[k] = content * (state.temperature[begin + k] - mold);
  }
  const double gate = step.gate_volume[node];
  for (std::size_t k = 0; k < count && gate > 0; ++k)
    system.right[k] += gate * motion.gate_share(node, k) * (inlet - mold);
  for (const ShellNeighbour& from : mesh_->neighbours(node)) {
    const double volume = step.inflow(node, from);
    if (!(volume > 0)) continue;
    const std::size_t there = from.node;
    for (std::size_t k = 0; k < count; ++k)
      system.right[k] +=
          volume * motion.share(there, node, k) * (state.temperature[there * count + k] - mold);
  }
  for (const LayerTransfer& t : step.transfers_of(node, count)) system.m(t.to, t.from) -= t.volume;
  // Both halves of the gap count: their areas conduct side by side.
  const double area = 2 * mesh_->area(node) * step.new_content[node] / mesh_->volume(node);
  const double half = mesh_->thickness(node) / 2;
  const double conduction = area * material.conductivity * step.duration / (capacity * half);
  for (std::size_t k = 0; k + 1 < count; ++k) {
    const double c = conduction / (layers_->middles()[k + 1] - layers_->middles()[k]);
    system.m(k, k) += c;
    system.m(k + 1, k + 1) += c;
    system.m(k, k + 1) -= c;
    system.m(k + 1, k) -= c;
  }
  const double wall_resistance = (1 - layers_->middles()[count - 1]) / conduction +
                                 capacity / (area * params_->process.wall_transfer * step.duration);
  system.m(count - 1, count - 1) += 1 / wall_resistance;
  std::array<double, most_half_layers> share;
  dissipation_shares(*layers_, std::span(motion.field.inverse_viscosity).subspan(begin, count),
                     std::span(share).first(count));
  for (std::size_t k = 0; k < count; ++k) system.right[k] += dissipated_[node] / capacity * share[k];
  system.solve(step.at_front[node] != 0 ? count : 1);
  for (std::size_t k = 0; k < count; ++k) state.temperature[begin + k] = mold + system.right[k];
  to_mold_[node] = capacity * system.right[count - 1] / wall_resistance;
  brought_in_[node] = capacity * std::max(gate, 0.0) * (inlet - mold);
  for (std::size_t k = 0; k < count && gate < 0; ++k)
    brought_in_[node] += capacity * gate * motion.field.shares[begin + k] * system.right[k];
}

void HeatTransport::begin(const StepFlow& step, const FlowField& field) {
  collect_dissipation(step, field);
  to_mold_.assign(mesh_->node_count(), 0);
  brought_in_.assign(mesh_->node_count(), 0);
}

void HeatTransport::advance(std::span<const Index> nodes, const MeltMotion& motion, FillingState& state) {
  for (const Index node : nodes) advance_node(node, motion, state);
}

void HeatTransport::end(FillingState& state) const {
  for (std::size_t i = 0; i < mesh_->node_count(); ++i) {
    state.heat.dissipated += dissipated_[i];
    state.heat.to_mold += to_mold_[i];
    state.heat.brought_in += brought_in_[i];
  }
}

void require_bearable_temperatures(const ShellMesh& mesh, const FillingParams& params,
                                   const FillingState& state) {
  const double bearable =
      std::max(params.process.inlet_temperature, params.process.mold_temperature) + bearable_rise;
  const std::size_t layers = state.temperature.size() / mesh.node_count();
  for (std::size_t point = 0; point < state.temperature.size(); ++point) {
    if (state.temperature[point] <= bearable) continue;  // false for NaN
    const Vec3& x = mesh.shell().nodes[point / layers];
    throw SimulationFailure(
        fmt::format(
            "the melt is at {:.4g} K at ({:.4g}, {:.4g}, {:.4g}) m, which no polymer bears: check the "
            "viscosity and the flow rate, or give the pressure that the machine has at most",
            state.temperature[point], x[0], x[1], x[2]),
        {state.steps, state.time, -1, 0});
  }
}

double stored_heat(const ShellMesh& mesh, const FillingParams& params, const GapLayers& layers,
                   const FillingState& state) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    const double content = mesh.volume(i) * state.filled[i] + state.excess[i];
    for (std::size_t k = 0; k < layers.count() && content > 0; ++k)
      sum += content * layers.widths()[k] *
             (state.temperature[i * layers.count() + k] - params.process.mold_temperature);
  }
  return sum * params.material.density * params.material.heat_capacity;
}

}  // namespace fiberfate
