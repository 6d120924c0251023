// Meshes surfaces that are made of flat patches with straight edges.
#pragma once

#include "base/patched_surface.hpp"
#include "io/surface_mesh.hpp"

namespace fiberfate {

/// Meshes patches with triangles (frontal Delaunay, on one thread; the same input gives the same mesh). The
/// normal of a triangle is that about which the outer loop runs counter-clockwise. Raises InputError when the
/// patches cannot be meshed: an edge crosses another, a loop is not flat.
[[nodiscard]] SurfaceMesh mesh_patches(const PatchedSurface& surface);

}  // namespace fiberfate
