// Evaluates the forces of contacts in packs.
#pragma once

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
  int law;                          ///< of the normal force: its place in ContactLaws
  const double* laws;               ///< its constants, by pair of materials
  int law_stride;                   ///< from the constants of one pair to those of the next
  int materials;
  int friction;  ///< law of friction: its place in FrictionLaws
  const double* friction_constants;
};

/// Evaluates the force of every contact of a chunk, in order, with the kernel of this processor.
void evaluate_forces(const ContactChunk& contacts, const ForceQuery& query, PairForce* forces);

}  // namespace fiberfate
