// A surface in space as triangles with named regions.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// Triangles in space. The three points of a triangle run counter-clockwise about its normal.
struct SurfaceMesh {
  std::vector<Vec3> points;                     ///< m; every point is of some triangle
  std::vector<std::array<Index, 3>> triangles;  ///< points of each
  std::vector<Index> regions;                   ///< region of each triangle
  std::vector<std::string> region_names;
  std::vector<std::size_t> numbers = {};  ///< of each triangle in the file that it comes from
  std::vector<std::string> remarks = {};  ///< what was mended when it was read, for people
};

}  // namespace fiberfate
