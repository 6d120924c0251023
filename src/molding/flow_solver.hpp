// Solves for pressure, fluxes and shear rates at one time: Hele-Shaw flow with a viscosity by layer.
#pragma once

#include <span>
#include <vector>

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"
#include "molding/flow_field.hpp"
#include "molding/gap_layers.hpp"
#include "molding/gate_nodes.hpp"
#include "molding/pressure_system.hpp"

namespace fiberfate {

/// What drives the flow in one step.
struct Drive {
  double rate = 0;      ///< that the machine aims at, m³/s; 0: all melt is in and settles
  double pressure = 0;  ///< at the sprue that it does not exceed, Pa
  double duration = 0;  ///< over which volume in excess shall find room, s
};

/// Solves div(S grad p) = 0, S = (H³/4) int zeta²/eta dzeta, over the wet nodes with linear elements: flux
/// from node to node F = w (p_i - p_j), w = sum over triangles of S cot/2, which conserves volume. Obtuse
/// pairs of triangles, whose w would be negative, do not conduct. The edge to a node of the front that is
/// filled to the share f is 1/2 + f of its length long, where p = 0. Viscosity and pressure are iterated:
/// rate = h zeta |grad p|/eta, at fixed flow (Picard on rates). Neither the machine nor the excess of
/// full nodes makes more than `greatest_pressure`: flow that would need more is slower.
class FlowSolver {
 public:
  FlowSolver(const ShellMesh& mesh, const FillingParams& params, const GapLayers& layers);

  /// Sets which gates are open.
  void set_gates(std::vector<GateLink> open_gates, const std::vector<Gate>& gates);
  /// Solves for the flow at the state; updates its shear rates and `field`. `stretching` is 1 + R
  /// (D:A4:D)/(D:D) by point, or empty. Raises SimulationFailure when the pressure is not finite.
  void solve(FillingState& state, const Drive& drive, std::span<const double> stretching, FlowField& field);
  [[nodiscard]] const ShellMesh& mesh() const { return *mesh_; }
  /// How much an edge conducts in an empty part of unit fluidity, m³.
  [[nodiscard]] double edge_weight(Index edge) const { return edge_weights_[edge]; }
  /// The viscosity of every point, Pa s; frozen layers have that of their temperature.
  void viscosities(const FillingState& state, std::size_t node, std::span<const double> stretching,
                   std::span<double> values) const;

 private:
  void wet_nodes(const FillingState& state, FlowField& field) const;
  void update_node(const FillingState& state, std::span<const double> stretching, std::size_t node,
                   FlowField& field);
  void update_conductances(const FillingState& state, const FlowField& field);
  /// Lets full nodes give up no more of their excess than `greatest_pressure` can drive.
  void bound_sources(FlowField& field);
  void apply_drive(const Drive& drive, FlowField& field);
  void update_fluxes(FlowField& field) const;
  [[nodiscard]] Vec2 gradient_at(const FillingState& state, const FlowField& field, std::size_t node) const;
  /// Updates gradients, rates, viscosities, and pressures unless melt settles: what moves it then is no
  /// pressure of the machine. Returns the largest change of a fluidity.
  double update_melt(const Drive& drive, std::span<const double> stretching, FillingState& state,
                     FlowField& field);

  const ShellMesh* mesh_;
  const FillingParams* params_;
  const GapLayers* layers_;
  PressureSystem system_;
  PressureParts parts_;
  std::vector<GateEdge> gate_edges_;  ///< that leave open round gates
  std::vector<double> edge_weights_;  ///< by edge: sum of H³ cot/8 of its triangles, m³
  std::vector<double> conductances_, to_front_;
  std::vector<double> change_;  ///< by node: relative change of the fluidity
  double least_fluidity_ = 0;   ///< that keeps a frozen node in the network, 1/(Pa s)
};

}  // namespace fiberfate
