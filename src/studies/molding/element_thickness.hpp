// Gives every triangle of a mesh from a file a thickness of its own.
#pragma once

#include <vector>

#include "io/surface_mesh.hpp"
#include "studies/molding/part.hpp"

namespace fiberfate {

/// Whether the case gives thicknesses by element.
[[nodiscard]] inline bool has_element_thickness(const PartChoices& part) {
  return !part.thickness_file.empty() || !part.thickness_data.empty();
}

/// Reads the thicknesses, m, in the order of the triangles of `mesh`, from part.thickness_file or from the
/// $ElementData part.thickness_data of the mesh's own file. Raises InputError, under the key, that tells of
/// elements without a thickness, with two, with one that is not positive or too large, and numbers that are
/// no triangle's.
[[nodiscard]] std::vector<double> element_thickness(const PartChoices& part, const SurfaceMesh& mesh);

}  // namespace fiberfate
