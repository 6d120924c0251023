// Assembles the systems of eight fibers: drag and bending in packs, then the loads on single rods.
#include "dynamics/chain_assembly.hpp"

#include "base/simd.hpp"
#include "dynamics/chain_solver.hpp"

namespace fiberfate {

namespace baseline {
void assemble_chains(const AssemblyQuery& query, const ChainGroup& group);
}
namespace avx2 {
void assemble_chains(const AssemblyQuery& query, const ChainGroup& group);
}
namespace avx512 {
void assemble_chains(const AssemblyQuery& query, const ChainGroup& group);
}

namespace {

using System = ChainSystem;

void assemble_chains(const AssemblyQuery& query, const ChainGroup& group) {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::assemble_chains(query, group);
    case InstructionSet::avx2:
      return avx2::assemble_chains(query, group);
    default:
      return baseline::assemble_chains(query, group);
  }
}

/// Holds the loads of a rod as they are added to the records of its two nodes.
struct LanePlace {
  double* near;  ///< record of the rod's first node, in the fiber's lane
  double* far;
};

LanePlace place_of(ChainSystem& system, int lane, Index rod) {
  return {system.record(rod) + lane, system.record(rod + 1) + lane};
}

/// Adds a load; symmetric blocks are xx, yy, zz, yz, zx, xy.
void add(const LanePlace& to, const RodLoad& load) {
  const double s = load.lever;
  for (int c = 0; c < 3; ++c) {
    to.near[(System::load + c) * System::lanes] += (1 - s) * load.force[c];
    to.far[(System::load + c) * System::lanes] += s * load.force[c];
  }
  for (int c = 0; c < 6; ++c) {
    const double resistance = load.resistance[static_cast<std::size_t>(c)];
    to.near[(System::diagonal + c) * System::lanes] += (1 - s) * (1 - s) * resistance;
    to.far[(System::diagonal + c) * System::lanes] += s * s * resistance;
    to.near[(System::coupling + c) * System::lanes] += s * (1 - s) * resistance;
  }
}

/// States one side of a pair's force as a load.
RodLoad pair_load(const ChainProblem& problem, const PairForce& pair, Index rod, bool is_first) {
  const double place = is_first ? pair.s : pair.t;
  const double sign = is_first ? 1 : -1;
  const auto k = static_cast<std::size_t>(rod);
  const Vec3 n(pair.normal[0], pair.normal[1], pair.normal[2]);
  const Vec3 force(pair.force[0], pair.force[1], pair.force[2]);
  const Vec3 old = (1 - place) * problem.pair_velocity[k] + place * problem.pair_velocity[k + 1];
  const double across = pair.across;
  const double excess = pair.along - across;
  return {place,
          sign * force + across * old + excess * n.dot(old) * n,
          {across + excess * n.x() * n.x(), across + excess * n.y() * n.y(), across + excess * n.z() * n.z(),
           excess * n.y() * n.z(), excess * n.z() * n.x(), excess * n.x() * n.y()}};
}

/// Collects the shares of a group's rods, fiber by fiber; `ends` receives where each rod's shares end.
void collect_shares(const PairForces& pairs, const ChainGroup& group, GroupShares& into) {
  into.shares.clear();
  into.ends.clear();
  for (int lane = 0; lane < System::lanes; ++lane) {
    for (int i = 0; i < group.used[lane]; ++i) {
      pairs.of_rod(group.first[lane] + i, into.shares);
      into.ends.push_back(into.shares.size());
    }
  }
  // They lie far apart: fetch them while drag and bending are assembled.
  for (const PairForces::Share& share : into.shares) {
    const auto* bytes = reinterpret_cast<const char*>(&pairs.forces()[static_cast<std::size_t>(share.force)]);
    __builtin_prefetch(bytes);
    __builtin_prefetch(bytes + sizeof(PairForce) - 1);
  }
}

void add_pair_forces(const ChainProblem& problem, const ChainGroup& group, ChainSystem& system) {
  const auto forces = problem.pairs->forces();
  std::size_t rod_number = 0;
  std::size_t next = 0;
  for (int lane = 0; lane < System::lanes; ++lane) {
    for (int i = 0; i < group.used[lane]; ++i) {
      for (const std::size_t end = system.shares().ends[rod_number++]; next < end; ++next) {
        const PairForces::Share& share = system.shares().shares[next];
        add(place_of(system, lane, i), pair_load(problem, forces[static_cast<std::size_t>(share.force)],
                                                 group.first[lane] + i, share.is_first));
      }
    }
  }
}

void add_rod_loads(const RodLoads& loads, const ChainGroup& group, ChainSystem& system) {
  for (int lane = 0; lane < System::lanes; ++lane) {
    for (int i = 0; i < group.used[lane]; ++i) {
      for (const RodLoad& load : loads.of_rod(group.first[lane] + i)) add(place_of(system, lane, i), load);
    }
  }
}

}  // namespace

void assemble_group(const ChainProblem& problem, const ChainGroup& group, ChainSystem& system) {
  const Mat3 strain_rate = problem.flow.rate_of_strain();
  const AssemblyQuery query{system.record(0),
                            problem.state.position[0].data(),
                            problem.geometry[0].data(),
                            problem.state.rod_length.data(),
                            &problem.unit_drag[0].parallel,
                            problem.flow.gradient.data(),
                            strain_rate.data(),
                            problem.flow.viscosity,
                            problem.step,
                            problem.is_anisotropic};
  if (problem.pairs != nullptr) collect_shares(*problem.pairs, group, system.shares());
  assemble_chains(query, group);
  if (problem.pairs != nullptr) add_pair_forces(problem, group, system);
  if (!problem.loads.is_empty()) add_rod_loads(problem.loads, group, system);
}

}  // namespace fiberfate
