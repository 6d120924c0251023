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

/// Adds one side of a pair's force. The skin where the rods touch moves with the rod's nodes at
///   v = (1 − s) w_k + s w_{k+1} + e M (w_{k+1} − w_k),   M = p nᵀ − (n·p) I,   e = ± d/2l
/// (+ on the first rod, − on the second), so nodes get the transposed shares of the force there. Turning
/// moves the skins along each other only: nᵀM = 0.
void add(const ChainProblem& problem, const LanePlace& to, const PairForce& pair, Index rod, bool is_first) {
  const auto k = static_cast<std::size_t>(rod);
  const double far = is_first ? pair.s : pair.t;
  const double near = 1 - far;
  const double sign = is_first ? 1 : -1;
  const double per_length = 1 / problem.state.rod_length[k];
  const Vec3 p = per_length * (problem.state.position[k + 1] - problem.state.position[k]);
  const Vec3 n(pair.normal[0], pair.normal[1], pair.normal[2]);
  const double cosine = n.dot(p);
  const double turn = sign * 0.5 * pair.distance * per_length;

  const Vec3& w = problem.pair_velocity[k];
  const Vec3 change = problem.pair_velocity[k + 1] - w;
  const Vec3 old = w + far * change + turn * (n.dot(change) * p - cosine * change);
  const double across = pair.across;
  const double excess = pair.along - across;
  const Vec3 force =
      sign * Vec3(pair.force[0], pair.force[1], pair.force[2]) + across * old + excess * n.dot(old) * n;
  const Vec3 couple = turn * (p.dot(force) * n - cosine * force);
  add(to.near, System::load, near * force - couple);
  add(to.far, System::load, far * force + couple);

  const Mat3 identity = Mat3::Identity();
  const Mat3 nn = n * n.transpose();
  const Mat3 pn = p * n.transpose();
  const Mat3 turning = turn * (pn - cosine * identity);
  const Mat3 both = turning + turning.transpose();
  const Mat3 squared = turn * turn * (nn - cosine * (pn + pn.transpose()) + cosine * cosine * identity);
  const Mat3 held = across * identity + excess * nn;
  add_to_diagonal(to.near, near * near * held + across * (squared - near * both));
  add_to_diagonal(to.far, far * far * held + across * (squared + far * both));
  add_to_coupling(to.near,
                  near * far * held + across * (near * turning - far * turning.transpose() - squared));
}

/// Collects the shares of a group's rods, fiber by fiber; `ends` receives where each rod's shares end.
void collect_shares(const PairForces& pairs, const ChainGroup& group, GroupShares& into) {
  into.shares.clear();
  into.ends.clear();
  for (int lane = 0; lane < System::lanes; ++lane) {
    for (int i = 0; i < group.used[lane]; ++i) pairs.fetch(group.first[lane] + i);
  }
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
        const PairForce& pair = forces[static_cast<std::size_t>(share.force)];
        const Index rod = group.first[lane] + i;
        const LanePlace place = place_of(system, lane, i);
        add(problem, place, pair, rod, share.is_first);
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
