// Solves for the velocities of all fibers: drag, bending and loads balance on every node, rods keep their
// length.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/threads.hpp"
#include "dynamics/chain_assembly.hpp"
#include "dynamics/chain_system.hpp"
#include "dynamics/drag_laws/rod_drag.hpp"
#include "dynamics/hinge_laws/hinge_registry.hpp"
#include "dynamics/pair_forces.hpp"
#include "dynamics/rod_loads.hpp"
#include "fibers/state.hpp"
#include "microstructure/flow.hpp"

namespace fiberfate {

/// States the problem of one step.
struct ChainProblem {
  const FiberState& state;                      ///< positions at the step's begin
  IndexedSpan<NodeIndex, const Vec3> geometry;  ///< where drag and inextensibility hold (mid-step), m
  const RodLoads& loads;                        ///< forces on rods, implicit in their velocity
  Flow flow;
  double step = 0;                    ///< over which bending is implicit, s; 0 makes it explicit
  const PairForces* pairs = nullptr;  ///< forces between rods, linearised about ...
  IndexedSpan<NodeIndex, const Vec3> pair_velocity = {};  ///< ... these velocities w, m/s
};

/// The laws by which fibers resist.
struct ChainLaws {
  std::string drag = "beads";     ///< a row of drag_laws()
  std::string hinge = "elastic";  ///< a row of hinge_laws()
};

/// Receives the solution.
struct ChainSolution {
  IndexedSpan<NodeIndex, Vec3> relative_velocity;  ///< w = v − kappa·x, m/s
  /// λ, N (axial parts of drag couples and bending included); room for a rod at every node.
  IndexedSpan<RodIndex, double> tension;
};

/// Solves, for every fiber with nodes k and rods i,
///   sum over adjoining rods of drag + bending + loads = 0 at every node,    p_i · (v_{i+1} − v_i) = 0
/// in the unknowns w_k = v_k − kappa·x_k and tensions λ_i: a symmetric saddle system, block-banded, solved by
/// elimination along the fiber, eight fibers side by side (physics: docs/theory/particles.md).
class ChainSolver {
 public:
  /// Groups the fibers of a state by rod count and works out their drag; call again whenever fibers have been
  /// added or split.
  void arrange(const FiberState& state, const ChainLaws& laws);
  void solve(const ChainProblem& problem, ChainSolution solution);

 private:
  void group_fibers(const FiberState& state, IndexRange<FiberIndex> fibers);
  void arrange_rods(const FiberState& state, const IndexedVector<RodIndex, RodDrag>& drag);
  void solve_group(const ChainProblem& problem, const ChainGroup& group, ChainSystem& system,
                   const ChainSolution& solution);

  [[nodiscard]] double* rods_of(const ChainGroup& group) {
    return rods_.data() + std::ptrdiff_t{group.first_rods} * RodNumber::rod_numbers * ChainSystem::lanes;
  }

  Hinge hinge_{ChainLaws{}.hinge};
  bool is_anisotropic_ = false;  ///< whether some rod's drag along it differs from that across
  std::vector<ChainGroup> groups_;
  AlignedArray rods_;  ///< RodNumber, group after group
  /// First group of each thread's share: fibers are shared as everywhere, so that what a thread steps stays
  /// with it.
  std::vector<std::size_t> share_begin_;
  PerThread<ChainSystem> systems_;
};

/// Evaluates the drag of every rod for a viscosity of 1 Pa s.
[[nodiscard]] IndexedVector<RodIndex, RodDrag> unit_drag_of_rods(const FiberState& state,
                                                                 std::string_view law);

}  // namespace fiberfate
