// Iterates viscosity and pressure of Hele-Shaw flow.
#include "molding/flow_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "molding/gap_flow.hpp"

namespace fiberfate {
namespace {

/// Fluidity of a frozen node over that of fresh melt at rest: keeps the equations solvable, moves nothing.
constexpr double frozen_fluidity = 1e-9;
/// Shear rate at which fresh melt is rated, 1/s.
constexpr double first_rate = 10;

}  // namespace

FlowSolver::FlowSolver(const ShellMesh& mesh, const FillingParams& params, const GapLayers& layers)
    : mesh_(&mesh), params_(&params), layers_(&layers), system_(mesh) {
  edge_weights_.assign(mesh.edges().size(), 0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      edge_weights_[mesh.edges_of(t)[k]] +=
          std::pow(mesh.thickness_of(t), 3) / 4 * mesh.half_cotangents(t)[k];
  for (double& weight : edge_weights_) weight = std::max(weight, 0.0);
  const double viscosity = params.material.viscosity->at({first_rate, params.process.inlet_temperature, 0});
  least_fluidity_ = frozen_fluidity / (3 * viscosity);
}

void FlowSolver::set_gates(std::vector<GateLink> open_gates, const std::vector<Gate>& gates) {
  gate_edges_.clear();
  for (std::size_t g = 0; g < gates.size(); ++g) {
    if (open_gates[g].front == GateFront::inside) continue;
    const std::vector<GateEdge> leaving = edges_of_round_gate(gates[g], open_gates[g].nodes, *mesh_);
    gate_edges_.insert(gate_edges_.end(), leaving.begin(), leaving.end());
  }
  system_.set_gates(std::move(open_gates));
}

void FlowSolver::wet_nodes(const FillingState& state, FlowField& field) const {
  const std::size_t n = mesh_->node_count();
  field.wet.assign(n, 0);
  field.front_factor.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    field.wet[i] = state.filled[i] >= 1 ? 1 : 0;
    field.front_factor[i] = 1 / (0.5 + state.filled[i]);
  }
}

void FlowSolver::viscosities(const FillingState& state, std::size_t node, std::span<const double> stretching,
                             std::span<double> values) const {
  const std::size_t layers = layers_->count(), begin = node * layers;
  std::array<double, most_half_layers> pressure;
  std::fill_n(pressure.begin(), layers, state.pressure[node]);
  params_->material.viscosity->evaluate(std::span(state.rate).subspan(begin, layers),
                                        std::span(state.temperature).subspan(begin, layers),
                                        std::span(pressure).first(layers), values);
  if (stretching.empty()) return;
  for (std::size_t k = 0; k < layers; ++k) values[k] *= stretching[begin + k];
}

void FlowSolver::update_node(const FillingState& state, std::span<const double> stretching, std::size_t node,
                             FlowField& field) {
  const std::size_t layers = layers_->count(), begin = node * layers;
  const bool heat = params_->numerics.heat == HeatModel::full;
  std::array<double, most_half_layers> viscosity;
  viscosities(state, node, stretching, std::span(viscosity).first(layers));
  for (std::size_t k = 0; k < layers; ++k) {
    const bool still = heat && state.temperature[begin + k] < params_->material.no_flow_temperature;
    field.inverse_viscosity[begin + k] = still ? 0 : 1 / viscosity[k];
  }
  const double fluidity = std::max(
      least_fluidity_, flow_through_gap(*layers_, std::span(field.inverse_viscosity).subspan(begin, layers),
                                        std::span(field.shares).subspan(begin, layers)));
  change_[node] = std::abs(fluidity - field.fluidity[node]) / fluidity;
  field.fluidity[node] = fluidity;
}

void FlowSolver::update_conductances(const FillingState& state, const FlowField& field) {
  conductances_.assign(mesh_->edges().size(), 0);
  for (std::size_t t = 0; t < mesh_->triangle_count(); ++t) {
    double sum = 0;
    int count = 0;
    for (const Index node : mesh_->corners(t))
      if (field.wet[node] != 0) {
        sum += field.fluidity[node];
        ++count;
      }
    if (count == 0) continue;
    const double h = mesh_->thickness_of(t);
    const double conduction = h * h * h / 4 * sum / count;
    for (std::size_t k = 0; k < 3; ++k)
      conductances_[mesh_->edges_of(t)[k]] += conduction * mesh_->half_cotangents(t)[k];
  }
  for (std::size_t e = 0; e < conductances_.size(); ++e) {
    const auto [a, b] = mesh_->edges()[e];
    conductances_[e] = std::max(conductances_[e], 0.0);
    if (field.wet[a] != field.wet[b]) conductances_[e] *= field.front_factor[field.wet[a] != 0 ? b : a];
  }
  for (const GateEdge& edge : gate_edges_) {
    conductances_[edge.edge] *= edge.scale;
    if (field.wet[edge.outside] != 0) continue;
    conductances_[edge.edge] *=
        edge.front_factor(state.filled[edge.outside]) / field.front_factor[edge.outside];
  }
  to_front_.assign(mesh_->node_count(), 0);
  for (std::size_t e = 0; e < conductances_.size(); ++e) {
    const auto [a, b] = mesh_->edges()[e];
    if (field.wet[a] != field.wet[b]) to_front_[field.wet[a] != 0 ? a : b] += conductances_[e];
  }
}

void FlowSolver::bound_sources(FlowField& field) {
  const double greatest = *std::max_element(parts_.of_sources.begin(), parts_.of_sources.end());
  if (!(greatest > greatest_pressure)) return;
  const double share = greatest_pressure / greatest;
  for (double& pressure : parts_.of_sources) pressure *= share;
  for (double& source : field.source) source *= share;
  parts_.sprue_of_sources *= share;
  field.released_share *= share;
}

void FlowSolver::apply_drive(const Drive& drive, FlowField& field) {
  field.rate = drive.rate;
  field.sprue_pressure = drive.rate * parts_.sprue_of_unit_rate + parts_.sprue_of_sources;
  field.limited = field.sprue_pressure > drive.pressure;
  if (field.limited) {
    field.rate = std::max(0.0, (drive.pressure - parts_.sprue_of_sources) / parts_.sprue_of_unit_rate);
    field.sprue_pressure = field.rate * parts_.sprue_of_unit_rate + parts_.sprue_of_sources;
  }
  for (std::size_t i = 0; i < mesh_->node_count(); ++i)
    field.pressure[i] = field.rate * parts_.of_unit_rate[i] + parts_.of_sources[i];
}

void FlowSolver::update_fluxes(FlowField& field) const {
  field.edge_flux.assign(conductances_.size(), 0);
  for (std::size_t e = 0; e < conductances_.size(); ++e) {
    const auto [a, b] = mesh_->edges()[e];
    if (field.wet[a] == 0 && field.wet[b] == 0) continue;
    field.edge_flux[e] = conductances_[e] * (field.pressure[a] - field.pressure[b]);
  }
}

Vec2 FlowSolver::gradient_at(const FillingState& state, const FlowField& field, std::size_t node) const {
  // Least squares over the edges, each of weight 1/length².
  double xx = 0, xy = 0, yy = 0, x = 0, y = 0;
  for (const ShellNeighbour& to : mesh_->neighbours(node)) {
    const bool front = field.wet[to.node] == 0;
    const double length = front ? to.length * (0.5 + state.filled[to.node]) : to.length;
    const double slope = (field.pressure[to.node] - field.pressure[node]) / length;
    const Vec2& u = to.direction;
    xx += u[0] * u[0];
    xy += u[0] * u[1];
    yy += u[1] * u[1];
    x += u[0] * slope;
    y += u[1] * slope;
  }
  const double det = xx * yy - xy * xy;
  return det > 0 ? Vec2((yy * x - xy * y) / det, (xx * y - xy * x) / det) : Vec2(x, y);
}

double FlowSolver::update_melt(const Drive& drive, std::span<const double> stretching, FillingState& state,
                               FlowField& field) {
  const std::size_t layers = layers_->count();
  parallel_for(static_cast<std::ptrdiff_t>(mesh_->node_count()), [&](std::size_t node) {
    if (field.wet[node] == 0) return;
    if (drive.rate > 0) state.pressure[node] = field.pressure[node];
    field.gradient[node] = gradient_at(state, field, node);
    const double stress = field.gradient[node].norm() * mesh_->thickness(node) / 2;  // at the wall
    for (std::size_t k = 0; k < layers; ++k)
      state.rate[node * layers + k] =
          stress * layers_->shear_heights()[k] * field.inverse_viscosity[node * layers + k];
    update_node(state, stretching, node, field);
  });
  return *std::max_element(change_.begin(), change_.end());
}

void FlowSolver::solve(FillingState& state, const Drive& drive, std::span<const double> stretching,
                       FlowField& field) {
  const std::size_t n = mesh_->node_count(), points = n * layers_->count();
  field.inverse_viscosity.resize(points, 0);
  field.shares.resize(points, 0);
  field.fluidity.resize(n, 0);
  field.pressure.resize(n, 0);
  field.gradient.resize(n, Vec2::Zero());
  wet_nodes(state, field);
  field.source.assign(n, 0);
  field.released_share = 1;
  for (std::size_t i = 0; i < n; ++i)
    if (field.wet[i] != 0 && drive.duration > 0) field.source[i] = state.excess[i] / drive.duration;
  change_.assign(n, 0);
  parallel_for(static_cast<std::ptrdiff_t>(n), [&](std::size_t node) {
    if (field.wet[node] != 0) update_node(state, stretching, node, field);
  });
  for (int iteration = 0; iteration < params_->numerics.most_iterations; ++iteration) {
    update_conductances(state, field);
    system_.solve({field.wet, conductances_, to_front_, field.source}, state.covered, parts_);
    bound_sources(field);
    apply_drive(drive, field);
    update_fluxes(field);
    if (!std::isfinite(field.sprue_pressure))
      throw SimulationFailure("the pressure is not finite", {state.steps, state.time, -1, 0});
    if (update_melt(drive, stretching, state, field) < params_->numerics.viscosity_tolerance) break;
  }
}

}  // namespace fiberfate
