// Surfaces in STL files.
#pragma once

#include <string>

#include "io/surface_mesh.hpp"

namespace fiberfate {

/// Reads an STL file, text or binary; `unit` is the length in m of one unit of the file. The file repeats the
/// corners of every triangle: corners that agree within 1e-8 of the part's size become one point. The words
/// of a text may be in any case and its names of any length; each solid is a region. Facets that are given
/// twice, or that have two corners at one place, are left out, and the remarks of the mesh tell how many.
/// Raises InputError with line and column (text) or the number of the facet (binary).
[[nodiscard]] SurfaceMesh read_stl(const std::string& path, double unit);

}  // namespace fiberfate
