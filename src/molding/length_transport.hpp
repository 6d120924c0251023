// Carries fiber lengths with the melt and lets them decay on the way.
#pragma once

#include <memory>
#include <vector>

#include "continuum/phelps_solver.hpp"
#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"
#include "molding/flow_field.hpp"
#include "molding/gap_layers.hpp"
#include "molding/shell_mesh.hpp"
#include "molding/step_flow.hpp"

namespace fiberfate {

/// Transports every field of every length set: fields of a set are its classes of initial length, or the
/// bins of Phelps' law.
///
/// In a step of duration dt a layer that holds V and takes in Q mixes old and new and decays for as long as
/// melt stays in it, tau = 1/(1/dt + Q/(V dt)):
///   L = L_inf + (L_mixed - L_inf) exp(-k_f tau),
/// which is the implicit step of dL/dt = Q/(V dt) (L_in - L) - k_f (L - L_inf) with the rate constant
/// (exp(k_f tau) - 1)/tau: exact at rest and exact in steady plug flow. (Advecting first and breaking for dt
/// after is 12 % wrong whatever the mesh.) Layers that stand still break nothing.
///
/// Where a gate has numbers of its own, the amount of every class (what it keeps: fiber length or number) is
/// one more field that rides on the melt, and lengths of a class mix by amounts.
class LengthTransport {
 public:
  LengthTransport(const ShellMesh& mesh, const FillingParams& params, const GapLayers& layers);

  [[nodiscard]] std::size_t field_count() const { return field_begin_.back() + amount_count_; }
  [[nodiscard]] std::size_t field_begin(std::size_t set) const { return field_begin_[set]; }
  /// How many amounts stand behind the fields of the sets: none, or one a class.
  [[nodiscard]] std::size_t amount_count() const { return amount_count_; }
  [[nodiscard]] const PhelpsSolver* phelps(std::size_t set) const { return phelps_[set].get(); }
  /// The lengths of the bins of a set of Phelps' law, m; none for others.
  [[nodiscard]] std::span<const double> bin_lengths(std::size_t set) const { return bin_lengths_[set]; }

  /// Advances the lengths of nodes whose upstream neighbours are done.
  void advance(std::span<const Index> nodes, const MeltMotion& motion, FillingState& state) const;

 private:
  struct NodeScratch;
  void write_inlet(const InletFibers& inlet, std::span<double> fields) const;
  void take(const double* from, double volume, double* sum) const;
  void divide(double volume, double* sum) const;
  void advance_node(std::size_t node, const MeltMotion& motion, FillingState& state,
                    NodeScratch& scratch) const;
  void prepare_decay(std::size_t node, const MeltMotion& motion, const FillingState& state,
                     NodeScratch& scratch) const;
  void mix(LayerOfNode at, const MeltMotion& motion, std::span<double> sum, FillingState& state) const;
  void decay(LayerOfNode at, FillingState& state, const NodeScratch& scratch) const;

  const ShellMesh* mesh_;
  const FillingParams* params_;
  const GapLayers* layers_;
  std::vector<std::size_t> field_begin_;  ///< by set, one more
  std::size_t amount_count_ = 0;
  std::vector<std::unique_ptr<PhelpsSolver>> phelps_;
  std::vector<std::vector<double>> bin_lengths_;
  std::vector<std::vector<double>> inlets_;  ///< by gate: all fields
};

}  // namespace fiberfate
