// Evaluates the forces of contacts in packs.
#pragma once

#include "dynamics/contact_law.hpp"
#include "dynamics/contact_set.hpp"
#include "dynamics/pair_forces.hpp"

namespace fiberfate {

/// States what the forces of a chunk of contacts depend on besides the contacts. Plain pointers, because
/// kernels of several instruction sets share it.
struct ForceQuery {
  const double* position;           ///< of the nodes, three numbers a node, m
  const double* relative_velocity;  ///< w of the last solve, m/s
  const double* strain_rate;        ///< D by columns, 1/s
  double step;                      ///< s
  Friction friction;
  const NormalForce::Constants* laws;  ///< by pair of materials
  int materials;
};

/// Evaluates the force of every contact of a chunk, in order, with the kernel of this processor.
void evaluate_forces(const ContactChunk& contacts, const ForceQuery& query, PairForce* forces);

}  // namespace fiberfate
