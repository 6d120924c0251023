// Predicts the stiffness and thermal expansion of every triangle of a filled part.
#pragma once

#include <string>
#include <vector>

#include "continuum/stiffness.hpp"
#include "io/poly_frame.hpp"
#include "studies/molding/fields.hpp"

namespace fiberfate {

/// Holds the solid's properties in one triangle, gap-averaged.
struct TriangleProperties {
  Mat3 axes = Mat3::Identity();  ///< columns: 1 along most fibers in the surface, 2 across, 3 the normal
  EngineeringConstants constants;
  Vec3 expansion = Vec3::Zero();  ///< along the axes, 1/K
};

/// Tells whether a case gives what properties need: an orientation law and lengths.
[[nodiscard]] bool has_properties(const MoldingCase& values);

/// Averages orientation averages of the aligned composite over layers (uniform strain) and nodes. Triangles
/// that the melt did not reach have the matrix' properties. Couplings of shear and stretching that remain in
/// the axes of a triangle are left out of its constants.
[[nodiscard]] std::vector<TriangleProperties> triangle_properties(const MoldingFields& fields);

/// Makes a frame of the properties.
[[nodiscard]] PolyFrame properties_frame(const MoldingFields& fields,
                                         const std::vector<TriangleProperties>& properties);

/// Holds the solid between two heights of the gap, and its mirror image on the other side of the mid-plane.
struct Ply {
  double share = 0;  ///< of half the thickness
  std::vector<TriangleProperties> triangles;
};

/// Parts the gap into plies from the mid-plane to the wall, each with the mean properties of its layers: what
/// bends a part lies in the skins, which the mean over the gap does not tell.
[[nodiscard]] std::vector<Ply> plies(const MoldingFields& fields);

/// Names solvers of structures. Abaqus has triangles of three nodes that bend (S3); CalculiX makes solid
/// wedges of those, which bend half as far as they should, and takes six nodes (S6).
enum class StructuralSolver { abaqus, calculix };

/// Writes the part for a solver of structures: nodes, triangles, and for each the plies across its thickness
/// with their material axes, engineering constants and expansion; SI units. Raises StorageError.
void write_structural_input(const std::string& path, const Shell& shell, const std::vector<Ply>& plies,
                            StructuralSolver solver);

}  // namespace fiberfate
