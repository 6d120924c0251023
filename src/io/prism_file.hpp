// Writes stacks of prisms over a surface as VTKHDF UnstructuredGrid, and reads them back.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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

/// The cell type of a prism in VTK: two triangles, one over the other.
inline constexpr std::uint8_t vtk_wedge = 13;
inline constexpr std::size_t wedge_points = 6;

/// Lists the points of every prism, six each: those of the triangle below, then those above. VTK's wedge has
/// its first triangle's normal pointing out of it, away from the second.
[[nodiscard]] std::vector<std::int64_t> wedges_of(const PrismMesh& prisms);

/// Writes the prisms as one unstructured grid (VTKHDF 2.0, cells of type wedge) to a new file that then takes
/// the place of an older one; raises StorageError.
void write_prisms(const std::string& path, const PrismMesh& prisms);
/// Reads such a file; arrays come back as double. Raises StorageError where it holds anything else.
[[nodiscard]] PrismMesh read_prisms(const std::string& path);

}  // namespace fiberfate
