// Writes stacks of prisms over a surface as VTKHDF UnstructuredGrid.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "io/poly_frame.hpp"

namespace fiberfate {

/// Copies of a surface's points on several levels; every triangle makes a prism between each two
/// levels.
struct PrismMesh {
  std::vector<double> points;  ///< x, y, z of every point, level after level, m
  std::size_t levels = 0;
  std::vector<std::array<Index, 3>> triangles;  ///< points of one level
  std::vector<FrameArray> point_data;
};

/// Writes the prisms as one unstructured grid (VTKHDF 2.0, cells of type wedge) to a new file that then takes
/// the place of an older one; raises StorageError.
void write_prisms(const std::string& path, const PrismMesh& prisms);

}  // namespace fiberfate
