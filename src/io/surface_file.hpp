// Reads surfaces of triangles from Gmsh (.msh) and STL (.stl) files.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/surface_mesh.hpp"

namespace fiberfate {

/// Reads a surface; `unit` is the length in m of one unit of the file. In a .msh file the regions are the
/// physical surfaces, or where there are none the surfaces by number; points that no triangle uses are left
/// out; triangles keep the numbers that their elements have there. An .stl file is read as read_stl() says.
/// Triangles that run the other way round than their neighbours are turned, and the remarks of the mesh tell
/// how many. Raises InputError when the file is missing, is of another kind, is damaged, or holds no
/// triangles, or other elements in its surfaces.
[[nodiscard]] SurfaceMesh read_surface(const std::string& path, double unit);

/// One number for each of some elements, in any order.
struct ElementData {
  std::vector<std::size_t> elements;  ///< their numbers in the file
  std::vector<double> values;
};

/// Reads the $ElementData called `name` (its first string) of a .msh file, the first step where there are
/// several. Raises InputError when the file has none of that name, or data of another kind.
[[nodiscard]] ElementData read_element_data(const std::string& path, const std::string& name);

}  // namespace fiberfate
