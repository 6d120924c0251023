// Groups fibers by rod count and solves their systems eight at a time.
#include "dynamics/chain_solver.hpp"

#include <algorithm>

#include "base/kernels.hpp"
#include "base/threads.hpp"
#include "dynamics/drag_laws/drag_registry.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(void eliminate_chains(double* records, double* factors, int nodes))

namespace {

void eliminate(ChainSystem& system, int nodes) {
  return FIBERFATE_KERNEL(eliminate_chains)(system.record(0), system.factors(), nodes);
}

ChainGroup group_of(const FiberState& state, std::span<const FiberIndex> fibers) {
  ChainGroup group;
  for (std::size_t lane = 0; lane < ChainSystem::lanes; ++lane) {
    const bool is_used = lane < fibers.size();
    const FiberIndex fiber = is_used ? fibers[lane] : fibers[0];
    group.fiber[lane] = is_used ? fiber.value() : -1;
    group.first[lane] = state.begin_node(fiber).value();
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
  const auto first_of = [&](int share) {
    return FiberIndex(share_begin(numbers(state.first_node), share, shares));
  };
  for (int share = 0; share < shares; ++share) {
    group_fibers(state, {first_of(share), first_of(share + 1)});
    share_begin_.push_back(groups_.size());
  }
  arrange_rods(state, unit_drag_of_rods(state, laws.drag));
}

/// Groups fibers, the longest ones first.
void ChainSolver::group_fibers(const FiberState& state, IndexRange<FiberIndex> fibers) {
  std::vector<FiberIndex> order;
  for (const FiberIndex fiber : fibers) order.push_back(fiber);
  std::stable_sort(order.begin(), order.end(),
                   [&](FiberIndex a, FiberIndex b) { return state.rod_count(a) > state.rod_count(b); });
  for (std::size_t i = 0; i < order.size(); i += ChainSystem::lanes)
    groups_.push_back(
        group_of(state, {order.data() + i, std::min<std::size_t>(ChainSystem::lanes, order.size() - i)}));
}

void ChainSolver::arrange_rods(const FiberState& state, const IndexedVector<RodIndex, RodDrag>& drag) {
  is_anisotropic_ =
      std::ranges::any_of(drag, [](const RodDrag& rod) { return rod.parallel != rod.perpendicular; });
  int count = 0;
  for (ChainGroup& group : groups_) {
    group.first_rods = count;
    count += group.nodes;
  }
  rods_.reserve(std::size_t{RodNumber::rod_numbers * ChainSystem::lanes} * count);
  for (const ChainGroup& group : groups_) {
    for (int k = 0; k < group.nodes; ++k) {
      double* to = rods_of(group) + offset_of(RodNumber::length, k);
      for (int lane = 0; lane < ChainSystem::lanes; ++lane) {
        const RodIndex rod(group.first[lane] + std::min(k, group.rods[lane] - 1));
        const double numbers[] = {state.rod_length[rod], drag[rod].parallel, drag[rod].perpendicular,
                                  drag[rod].rotational, drag[rod].shape};
        for (int i = 0; i < RodNumber::rod_numbers; ++i) to[i * ChainSystem::lanes + lane] = numbers[i];
      }
    }
  }
}

void ChainSolver::solve(const ChainProblem& problem, ChainSolution solution) {
  systems_.fit();
  parallel_for(std::ssize(share_begin_) - 1, [&](std::size_t share) {
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
      const NodeIndex node(group.first[lane] + k);
      const double* record = system.record(k) + lane;
      const double* w = record + ChainSystem::load * ChainSystem::lanes;
      solution.relative_velocity[node] = Vec3(w[0], w[ChainSystem::lanes], w[2 * ChainSystem::lanes]);
      solution.tension[rod_after(node)] = record[ChainSystem::stretch * ChainSystem::lanes];
    }
  }
}

IndexedVector<RodIndex, RodDrag> unit_drag_of_rods(const FiberState& state, std::string_view law) {
  const DragRow& row = drag_law_named(law);
  IndexedVector<RodIndex, RodDrag> drag(state.rod_length.size());
  for (const FiberIndex fiber : state.fibers()) {
    const double radius = state.material(fiber).radius;
    const double whole = fiber_length(state, fiber);
    for (const RodIndex rod : state.rods(fiber))
      drag[rod] = row.drag(1.0, {state.rod_length[rod], radius, whole});
  }
  return drag;
}

}  // namespace fiberfate
