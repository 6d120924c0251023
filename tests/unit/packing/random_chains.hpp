// Makes random chains for the tests of packing.
#pragma once

#include <cstdint>

#include "base/random.hpp"
#include "packing/chains.hpp"

namespace fiberfate {

/// Ends a fiber whose nodes stand at the end of the positions already.
inline void end_fiber(Chains& chains, double rod_length, double radius, double bending_stiffness) {
  chains.first_node.push_back(NodeIndex(chains.position.size()));
  chains.rod_length.push_back(rod_length);
  chains.radius.push_back(radius);
  chains.swelling.push_back(1);
  chains.firmness.push_back(1);
  chains.bending_stiffness.push_back(bending_stiffness);
}

/// Random walks of equal rods with centres anywhere in the cell.
inline Chains random_chains(const Cell& cell, int fibers, int rods, double rod_length) {
  Chains chains;
  chains.cell = cell;
  for (int f = 0; f < fibers; ++f) {
    const auto u = uniform4(5, RandomStream::noise, {static_cast<std::uint32_t>(f), 0, 0});
    Vec3 node = cell.lattice * Vec3(u[0], u[1], u[2]);
    Vec3 direction = Vec3::UnitX();
    chains.position.push_back(node);
    for (int k = 0; k < rods; ++k) {
      const auto turn =
          uniform4(5, RandomStream::noise, {static_cast<std::uint32_t>(f), 1, static_cast<std::uint32_t>(k)});
      const Vec3 kick(turn[0] - 0.5, turn[1] - 0.5, turn[2] - 0.5);
      direction = k == 0 ? kick.normalized() : Vec3((direction + 0.5 * kick).normalized());
      node += rod_length * direction;
      chains.position.push_back(node);
    }
    end_fiber(chains, rod_length, f % 2 == 0 ? 0.5 : 0.3, 0.05);
  }
  chains.velocity.assign(chains.position.size(), Vec3::Zero());
  chains.force.assign(chains.position.size(), Vec3::Zero());
  return chains;
}

}  // namespace fiberfate
