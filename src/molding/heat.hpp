// Heat that rides on the melt, is conducted across the gap, and is made by viscous flow.
#pragma once

#include <span>
#include <vector>

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"
#include "molding/flow_field.hpp"
#include "molding/gap_layers.hpp"
#include "molding/shell_mesh.hpp"
#include "molding/step_flow.hpp"

namespace fiberfate {

/// Solves rho c DT/Dt = k d²T/dz² + eta rate² by an implicit step: one system of the layers of a node, from
/// node to node down the flow. The heat that flow makes is that which the pressure loses, edge by edge, so
/// that what gates pump in, F Delta p, is found again in the melt; layers share it by zeta²/eta. Neglected:
/// conduction in the surface (thickness over length squared), expansion, heat of solidification.
class HeatTransport {
 public:
  HeatTransport(const ShellMesh& mesh, const FillingParams& params, const GapLayers& layers)
      : mesh_(&mesh), params_(&params), layers_(&layers) {}

  /// Gets ready for a step, before the sweep down the flow.
  void begin(const StepFlow& step, const FlowField& field);
  /// Advances the temperatures of nodes whose upstream neighbours are done.
  void advance(std::span<const Index> nodes, const MeltMotion& motion, FillingState& state);
  /// Adds to the account of heat, after the sweep.
  void end(FillingState& state) const;

 private:
  void collect_dissipation(const StepFlow& step, const FlowField& field);
  void advance_node(std::size_t node, const MeltMotion& motion, FillingState& state);

  const ShellMesh* mesh_;
  const FillingParams* params_;
  const GapLayers* layers_;
  std::vector<double> dissipated_;  ///< by node, J in this step
  std::vector<double> to_mold_;     ///< by node, J in this step
  std::vector<double> brought_in_;  ///< by node, J in this step
};

/// Raises SimulationFailure where the melt is more than 1000 K hotter than it came in, or its temperature not
/// a number: no polymer bears that, and no viscosity law holds there.
void require_bearable_temperatures(const ShellMesh& mesh, const FillingParams& params,
                                   const FillingState& state);

/// The heat that the melt holds above the mold's temperature, J.
[[nodiscard]] double stored_heat(const ShellMesh& mesh, const FillingParams& params, const GapLayers& layers,
                                 const FillingState& state);

}  // namespace fiberfate
