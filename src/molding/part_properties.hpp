// Stiffness and thermal expansion of a filled part.
#pragma once

#include <vector>

#include "continuum/homogenisation.hpp"
#include "molding/filled_lengths.hpp"

namespace fiberfate {

/// What the solid is made of.
struct PartSolid {
  CompositeMaterial composite;
  Homogenisation model{};
  double fiber_diameter = 19e-6;  ///< m
};

/// The solid's properties in one triangle, gap-averaged.
struct TriangleProperties {
  Mat3 axes = Mat3::Identity();  ///< columns: 1 along most fibers in the surface, 2 across, 3 the normal
  EngineeringConstants constants;
  Vec3 expansion = Vec3::Zero();  ///< along the axes, 1/K
};

/// Averages orientation averages of the aligned composite over layers (uniform strain) and nodes. Triangles
/// that the melt did not reach have the matrix' properties. Couplings of shear and stretching that remain in
/// the axes of a triangle are left out of its constants.
[[nodiscard]] std::vector<TriangleProperties> triangle_properties(const FilledLengths& lengths,
                                                                  const PartSolid& solid);

/// The solid between two heights of the gap, and its mirror image on the other side of the mid-plane.
struct Ply {
  double share = 0;  ///< of half the thickness
  std::vector<TriangleProperties> triangles;
};

/// Parts the gap into plies from the mid-plane to the wall, each with the mean properties of its layers: what
/// bends a part lies in the skins, which the mean over the gap does not tell.
[[nodiscard]] std::vector<Ply> plies(const FilledLengths& lengths, const PartSolid& solid);

}  // namespace fiberfate
