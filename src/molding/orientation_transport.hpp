// Carries fiber orientation with the melt and lets the flow turn the fibers on the way.
#pragma once

#include <optional>
#include <vector>

#include "continuum/orientation_law.hpp"
#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"
#include "molding/flow_field.hpp"
#include "molding/gap_layers.hpp"
#include "molding/shell_mesh.hpp"
#include "molding/step_flow.hpp"

namespace fiberfate {

/// Solves DA/Dt = S(A) of the point law in every layer. As with lengths, a step mixes what is there with
/// what comes in and lets the law act for as long as melt stays in the layer, tau = 1/(1/dt + Q/(V dt)):
/// exact at rest and in steady plug flow, and a state that is steady in the flow stays so. Melt that changes
/// the layer behind the front counts with its state before the step. Components are those of the node's
/// frame; from node to node they keep their angle to the edge.
class OrientationTransport {
 public:
  OrientationTransport(const ShellMesh& mesh, const FillingParams& params, const GapLayers& layers);

  /// Advances the orientation of nodes whose upstream neighbours are done.
  void advance(std::span<const Index> nodes, const MeltMotion& motion, FillingState& state) const;

 private:
  struct Batch;
  [[nodiscard]] std::array<double, 6> inlet(std::size_t node, int gate, const FlowField& field) const;
  [[nodiscard]] std::array<double, 6> mixed(LayerOfNode at, const MeltMotion& motion,
                                            const FillingState& state) const;
  void load(std::span<const Index> nodes, const MeltMotion& motion, const FillingState& state,
            Batch& batch) const;
  void turn_and_store(double duration, Batch& batch, FillingState& state) const;

  const ShellMesh* mesh_;
  const FillingParams* params_;
  const GapLayers* layers_;
  std::optional<OrientationLaw> law_;
};

}  // namespace fiberfate
