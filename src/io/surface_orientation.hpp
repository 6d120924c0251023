// The sides of triangles, made to agree over a surface.
#pragma once

#include <cstddef>

#include "io/surface_mesh.hpp"

namespace fiberfate {

/// Turns triangles until neighbours run the same way round, and tells how many were turned: in each piece of
/// the surface the lesser part. Neighbours share an edge that belongs to no third triangle. A piece that has
/// one side only (a Möbius strip) stays as it is.
std::size_t turn_to_agree(SurfaceMesh& mesh);

}  // namespace fiberfate
