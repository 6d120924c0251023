// Groups fibers by rod count and solves their systems eight at a time.
#include "dynamics/chain_solver.hpp"

#include <algorithm>
#include <numeric>

#include "base/kernels.hpp"
#include "base/threads.hpp"
#include "dynamics/drag_laws/drag_registry.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(void eliminate_chains(double* records, double* factors, int nodes))

namespace {

void eliminate(ChainSystem& system, int nodes) {
  return FIBERFATE_KERNEL(eliminate_chains)(system.record(0), system.factors(), nodes);
}

ChainGroup group_of(const FiberState& state, std::span<const Index> fibers) {
  ChainGroup group;
  for (std::size_t lane = 0; lane < ChainSystem::lanes; ++lane) {
    const bool is_used = lane < fibers.size();
    const Index fiber = is_used ? fibers[lane] : fibers[0];
    group.fiber[lane] = is_used ? fiber : -1;
    group.first[lane] = state.begin_node(fiber);
    group.rods[lane] = state.rod_count(fiber);
    group.used[lane] = is_used ? group.rods[lane] : 0;
    group.bending_stiffness[lane] = state.material(fiber).bending_stiffness();
    group.nodes = std::max(group.nodes, group.rods[lane] + 1);
  }
  return group;
}

}  // namespace

void ChainSolver::arrange(const FiberState& state, const ChainLaws& laws) {
  hinge_ = Hinge(laws.hinge);
  groups_.clear();
  share_begin_.assign(1, 0);
  const int shares = thread_count();
  for (int share = 0; share < shares; ++share) {
    group_fibers(state, static_cast<Index>(share_begin(state.first_node, share, shares)),
                 static_cast<Index>(share_begin(state.first_node, share + 1, shares)));
    share_begin_.push_back(groups_.size());
  }
  arrange_rods(state, unit_drag_of_rods(state, laws.drag));
}

/// Groups the fibers from `begin` to `end`, the longest ones first.
void ChainSolver::group_fibers(const FiberState& state, Index begin, Index end) {
  std::vector<Index> order(static_cast<std::size_t>(end - begin));
  std::iota(order.begin(), order.end(), begin);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return state.rod_count(a) > state.rod_count(b); });
  for (std::size_t i = 0; i < order.size(); i += ChainSystem::lanes)
    groups_.push_back(
        group_of(state, {order.data() + i, std::min<std::size_t>(ChainSystem::lanes, order.size() - i)}));
}

void ChainSolver::arrange_rods(const FiberState& state, const std::vector<RodDrag>& drag) {
  is_anisotropic_ =
      std::ranges::any_of(drag, [](const RodDrag& rod) { return rod.parallel != rod.perpendicular; });
  int count = 0;
  for (ChainGroup& group : groups_) {
    group.first_rods = count;
    count += group.nodes;
  }
  rods_.reserve(static_cast<std::size_t>(count) * RodNumber::rod_numbers * ChainSystem::lanes);
  for (const ChainGroup& group : groups_) {
    for (int k = 0; k < group.nodes; ++k) {
      double* to = rods_of(group) + offset_of(RodNumber::length, k);
      for (int lane = 0; lane < ChainSystem::lanes; ++lane) {
        const auto rod = static_cast<std::size_t>(group.first[lane] + std::min(k, group.rods[lane] - 1));
        const double numbers[] = {state.rod_length[rod], drag[rod].parallel, drag[rod].perpendicular,
                                  drag[rod].rotational, drag[rod].shape};
        for (int i = 0; i < RodNumber::rod_numbers; ++i) to[i * ChainSystem::lanes + lane] = numbers[i];
      }
    }
  }
}

void ChainSolver::solve(const ChainProblem& problem, ChainSolution solution) {
  systems_.fit();
  parallel_for(static_cast<std::ptrdiff_t>(share_begin_.size()) - 1, [&](std::ptrdiff_t s) {
    const auto share = static_cast<std::size_t>(s);
    for (std::size_t g = share_begin_[share]; g < share_begin_[share + 1]; ++g)
      solve_group(problem, groups_[g], systems_.mine(), solution);
  });
}

void ChainSolver::solve_group(const ChainProblem& problem, const ChainGroup& group, ChainSystem& system,
                              const ChainSolution& solution) {
  system.reserve(group.nodes);
  assemble_group(problem, {group, rods_of(group), hinge_, is_anisotropic_}, system);
  eliminate(system, group.nodes);
  for (int lane = 0; lane < ChainSystem::lanes; ++lane) {
    for (int k = 0; k <= group.used[lane] && group.fiber[lane] >= 0; ++k) {
      const auto n = static_cast<std::size_t>(group.first[lane] + k);
      const double* record = system.record(k) + lane;
      const double* w = record + ChainSystem::load * ChainSystem::lanes;
      solution.relative_velocity[n] = Vec3(w[0], w[ChainSystem::lanes], w[2 * ChainSystem::lanes]);
      solution.tension[n] = record[ChainSystem::stretch * ChainSystem::lanes];
    }
  }
}

std::vector<RodDrag> unit_drag_of_rods(const FiberState& state, std::string_view law) {
  const DragRow& row = drag_law_named(law);
  std::vector<RodDrag> drag(static_cast<std::size_t>(state.node_count()));
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    const double radius = state.material(fiber).radius;
    const double whole = fiber_length(state, fiber);
    for (Index k = state.begin_node(fiber); k + 1 < state.end_node(fiber); ++k) {
      const auto n = static_cast<std::size_t>(k);
      drag[n] = row.drag(1.0, {state.rod_length[n], radius, whole});
    }
  }
  return drag;
}

}  // namespace fiberfate
