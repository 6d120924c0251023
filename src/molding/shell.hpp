// A part as its reader or mesher makes it: triangles of the middle surface with a thickness.
#pragma once

#include <array>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

using Vec2 = Eigen::Vector2d;

/// Chooses whether more than two triangles may share an edge, as where a rib stands on a plate.
enum class Junctions { refused, allowed };

/// Triangles of the middle surface, as a reader or mesher makes them.
struct Shell {
  std::vector<Vec3> nodes;                      ///< m
  std::vector<std::array<Index, 3>> triangles;  ///< nodes of each, the same way round seen from one side
  std::vector<double> thickness;                ///< full wall thickness of each triangle, m
  std::vector<int> region = {};  ///< of each triangle, as the mesher numbers them; may be empty
  Junctions junctions = Junctions::refused;
};

/// The volume of its triangles, m³.
[[nodiscard]] double volume_of(const Shell& shell);

/// Checks a shell. Raises InputError that lists the faults with the triangle or node, its place and the
/// remedy: missing or unused nodes, degenerate triangles, thickness that is not positive, edges of more than
/// two triangles, neighbours that are turned the other way, open seams (nodes that coincide but are not
/// shared), surfaces that touch in a point or are closed as the skin of a solid is, a part in several pieces.
void check_shell(const Shell& shell);

}  // namespace fiberfate
