// Writes the systems of eight fibers: drag and couple of every rod, implicit bending of every hinge, loads.
#pragma once

#include "base/vector.hpp"

namespace fiberfate {

struct ChainProblem;
class ChainSystem;
class Hinge;

/// Eight fibers that are solved side by side, with what their lanes need. Plain numbers, because
/// kernels of several instruction sets share it. A lane without a fiber repeats lane 0, of which it uses
/// nothing.
struct ChainGroup {
  int nodes = 0;                                 ///< of the longest fiber
  int first_rods = 0;                            ///< where its rods' numbers begin, in eights of rods
  Index fiber[8] = {};                           ///< −1: lane unused
  alignas(32) Index first[8] = {};               ///< first node
  alignas(32) int rods[8] = {};                  ///< that can be read
  alignas(32) int used[8] = {};                  ///< that count: `rods`, or none where the lane is unused
  alignas(64) double bending_stiffness[8] = {};  ///< E I, N m²
};

/// Numbers of the k-th rods of a group's fibers, which change only when fibers do: [k][number][lane]; as many
/// k as nodes, where a fiber has ended its last rod is repeated.
enum RodNumber {
  length,         ///< m
  parallel,       ///< drag for a viscosity of 1 Pa s, as RodDrag
  perpendicular,  ///< likewise
  rotational,     ///< likewise
  shape,          ///< likewise
  rod_numbers
};

/// Where a number of the k-th rods begins. Always inlined, because kernels of several instruction sets
/// call it.
[[gnu::always_inline]] static inline long offset_of(RodNumber number, int k) {
  return (static_cast<long>(k) * rod_numbers + number) * 8;
}

/// States what drag and bending depend on; arrays with one entry a node.
struct AssemblyQuery {
  double* records;            ///< of ChainSystem
  const double* position;     ///< where bending is taken, m
  const double* geometry;     ///< where drag and inextensibility are taken, m
  const double* rods;         ///< RodNumber: of the group
  const double* gradient;     ///< kappa by columns, 1/s
  const double* strain_rate;  ///< D by columns, 1/s
  double viscosity;           ///< Pa s
  double step;                ///< s
  bool is_anisotropic;        ///< whether parallel and perpendicular drag may differ
  int hinge;                  ///< law of bending: its place in HingeLaws
  const double* hinge_constants;
};

/// What is assembled: eight fibers, their rods' numbers (RodNumber), and how they resist.
struct ChainFibers {
  const ChainGroup& group;
  const double* rods;
  const Hinge& hinge;
  bool is_anisotropic;  ///< whether parallel and perpendicular drag may differ
};

/// Assembles drag, bending and loads of a group.
void assemble_group(const ChainProblem& problem, const ChainFibers& fibers, ChainSystem& system);

}  // namespace fiberfate
