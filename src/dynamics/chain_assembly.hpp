// Writes the system of one fiber into its lane.
#pragma once

#include "dynamics/chain_solver.hpp"

namespace fiberfate {

/// Says where a fiber's system goes.
struct ChainLane {
  ChainSystem& system;
  int lane = 0;
  int nodes = 0;  ///< of the group; those beyond the fiber's own become identities
};

/// Assembles drag, bending and loads of one fiber.
void assemble_chain(const ChainProblem& problem, Index fiber, ChainLane lane);

/// Fills a lane that has no fiber, or the nodes from `first` on, with identities.
void pad_chain(ChainLane lane, int first);

}  // namespace fiberfate
