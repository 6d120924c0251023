// Reads surfaces of triangles from Gmsh (.msh) and STL (.stl) files.
#pragma once

#include <string>

#include "io/surface_mesh.hpp"

namespace fiberfate {

/// Reads a surface; `unit` is the length in m of one unit of the file. In a .msh file the regions are the
/// physical surfaces, or where there are none the surfaces by number; points that no triangle uses are left
/// out. In an .stl file, which repeats the corners of every triangle, equal corners become one point. Raises
/// InputError when the file is missing, is of another kind, or holds no triangles, or other elements in its
/// surfaces.
[[nodiscard]] SurfaceMesh read_surface(const std::string& path, double unit);

}  // namespace fiberfate
