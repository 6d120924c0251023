// Triangles over the nodes of a shell that lead the flow along all of their edges.
#pragma once

#include <array>
#include <vector>

#include "molding/shell.hpp"

namespace fiberfate {

/// The triangles over which the flow is solved.
struct FlowTriangles {
  std::vector<std::array<Index, 3>> corners;
  std::vector<double> thickness;  ///< m
  std::size_t turned = 0;         ///< edges that are not those of the shell
};

/// Turns the edges of flat pairs of triangles until each is Delaunay: the angles opposite to it add up to at
/// most pi, so that its weight cot + cot in linear elements is not negative. The surface stays what it is, to
/// `flat_cosine`; so does the volume, since both triangles get the mean thickness of the pair. Left as they
/// are: rims, folds, junctions, and edges between walls of different thickness (`like_thickness`).
[[nodiscard]] FlowTriangles flow_triangles(const Shell& shell);

/// Cosine of the angle between the normals of two triangles that count as flat: 1 degree.
inline constexpr double flat_cosine = 0.99985;
/// Difference of two thicknesses over their mean up to which they may be averaged.
inline constexpr double like_thickness = 0.1;

}  // namespace fiberfate
