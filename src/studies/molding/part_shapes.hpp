// Draws the parts that a case describes: their flat patches, where their gates are, and how they bend in
// space.
#pragma once

#include <functional>
#include <vector>

#include "io/patch_mesher.hpp"
#include "studies/molding/part.hpp"

namespace fiberfate {

/// Holds a part before it is meshed.
struct PartShape {
  PatchedSurface surface;
  std::vector<Gate> gates;  ///< in flat coordinates, z = 0
  /// Puts a point of the drawing into space; lengths along the surface stay what they are.
  std::function<Vec3(const Vec3&)> place;
};

/// Draws any part but one from a file.
[[nodiscard]] PartShape draw_part(const PartChoices& part);

/// Tells the names of the nine gates of a tailgate and their flat coordinates (thesis table 14), m.
[[nodiscard]] std::vector<Gate> tailgate_gates(double radius);

}  // namespace fiberfate
