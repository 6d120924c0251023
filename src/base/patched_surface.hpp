// Surfaces of flat patches with straight edges: what is drawn before it is meshed.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// One flat patch: an area within one closed loop and outside of others.
struct Patch {
  std::string region;                           ///< patches may share one
  std::vector<std::vector<std::size_t>> loops;  ///< corners in order; the first loop is the outer one
  std::vector<std::array<std::size_t, 2>>
      inner_edges;                        ///< corners of edges inside, along which triangles meet
  std::vector<std::size_t> inner_points;  ///< corners inside that become points of the mesh
  bool operator==(const Patch&) const = default;
};

/// Patches that meet at edges: an edge between the same two corners is meshed once.
struct PatchedSurface {
  std::vector<Vec3> corners;  ///< m
  std::vector<double> sizes;  ///< edge length of triangles wanted at each corner, m
  std::vector<Patch> patches;
  bool operator==(const PatchedSurface&) const = default;
};

}  // namespace fiberfate
