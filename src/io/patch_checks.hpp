// Checks patches before they are meshed; only sources of io include it.
#pragma once

#include "io/patch_mesher.hpp"

namespace fiberfate {

/// Raises InputError when a patch is not flat, or when two of its edges touch anywhere but at a common
/// corner: Gmsh says nothing that would tell where.
void check_patches(const PatchedSurface& surface);

}  // namespace fiberfate
