// Assembles the systems of eight fibers: drag and bending in packs, then the loads on single rods.
#include "dynamics/chain_assembly.hpp"

#include "base/kernels.hpp"
#include "dynamics/chain_solver.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(void assemble_chains(const AssemblyQuery& query, const ChainGroup& group))

namespace {

using System = ChainSystem;

void assemble_chains(const AssemblyQuery& query, const ChainGroup& group) {
  return FIBERFATE_KERNEL(assemble_chains)(query, group);
}

/// The loads of a rod as they are added to the records of its two nodes.
struct LanePlace {
  double* near;  ///< record of the rod's first node, in the fiber's lane
  double* far;
};

LanePlace place_of(ChainSystem& system, int lane, int rod) {
  return {system.record(rod) + lane, system.record(rod + 1) + lane};
}

void add(double* record, int component, const Vec3& v) {
  for (int c = 0; c < 3; ++c) record[(component + c) * System::lanes] += v[c];
}
void add_to_diagonal(double* record, const Mat3& m) {
  const double parts[6] = {m(0, 0), m(1, 1), m(2, 2), m(1, 2), m(2, 0), m(0, 1)};
  for (int c = 0; c < 6; ++c) record[(System::diagonal + c) * System::lanes] += parts[c];
}
void add_to_coupling(double* record, const Mat3& m) {
  for (int c = 0; c < 9; ++c) record[(System::coupling + c) * System::lanes] += m.data()[c];
}

/// Adds a load; symmetric blocks are xx, yy, zz, yz, zx, xy.
void add(const LanePlace& to, const RodLoad& load) {
  const double s = load.lever;
  const auto& r = load.resistance;
  Mat3 resistance;
  resistance << r[0], r[5], r[4], r[5], r[1], r[3], r[4], r[3], r[2];
  add(to.near, System::load, (1 - s) * load.force);
  add(to.far, System::load, s * load.force);
  add_to_diagonal(to.near, (1 - s) * (1 - s) * resistance);
  add_to_diagonal(to.far, s * s * resistance);
  add_to_coupling(to.near, s * (1 - s) * resistance);
}

void add_rod_loads(const RodLoads& loads, const ChainGroup& group, ChainSystem& system) {
  for (int lane = 0; lane < System::lanes; ++lane) {
    const RodIndex first(group.first[lane]);
    for (int i = 0; i < group.used[lane]; ++i)
      for (const RodLoad& load : loads.of_rod(first + i)) add(place_of(system, lane, i), load);
  }
}

void add_pairs(const ChainProblem& problem, const ChainGroup& group, const double* rods,
               ChainSystem& system) {
  const PairSlots& slots = system.slots();
  const Vec3 &position = problem.state.position.front(), &velocity = problem.pair_velocity.front();
  add_pair_loads({system.record(0), position.data(), velocity.data(), rods, problem.pairs->forces().data(),
                  slots.numbers(), slots.ends(), slots.rod_count()},
                 group);
}

}  // namespace

void assemble_group(const ChainProblem& problem, const ChainFibers& fibers, ChainSystem& system) {
  const ChainGroup& group = fibers.group;
  const Mat3 strain_rate = problem.flow.rate_of_strain();
  const AssemblyQuery query{system.record(0),
                            problem.state.position.front().data(),
                            problem.geometry.front().data(),
                            fibers.rods,
                            problem.flow.gradient.data(),
                            strain_rate.data(),
                            problem.flow.viscosity,
                            problem.step,
                            fibers.is_anisotropic,
                            fibers.hinge.law(),
                            fibers.hinge.constants().data()};
  if (problem.pairs != nullptr) system.slots().collect(*problem.pairs, group);
  assemble_chains(query, group);
  if (problem.pairs != nullptr) add_pairs(problem, group, fibers.rods, system);
  if (!problem.loads.is_empty()) add_rod_loads(problem.loads, group, system);
}

}  // namespace fiberfate
