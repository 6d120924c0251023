// Finds the nodes next to walls.
#pragma once

#include <vector>

#include "fibers/state.hpp"

namespace fiberfate {

/// One node near a wall. Of a straight rod one of the nodes is nearest to a plane, so nodes suffice.
struct WallContact {
  NodeIndex node;
  RodIndex rod;                 ///< a rod that ends at the node
  Vec3 normal = Vec3::UnitY();  ///< from the wall into the cell
  double height = 0;            ///< of the node's axis above the wall, m
  std::uint16_t material = 0;
};

/// Lists the nodes within three diameters of a wall, in order of direction, side and node; further ones
/// cannot reach it in a step.
[[nodiscard]] std::vector<WallContact> find_wall_contacts(const FiberState& state);

}  // namespace fiberfate
