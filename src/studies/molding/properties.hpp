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

/// Writes the part for a structural solver: nodes, triangles (S3), and for each its thickness, material axes,
/// engineering constants and expansion, in keywords that Abaqus and CalculiX share; SI units. Raises
/// StorageError.
void write_structural_input(const std::string& path, const Shell& shell,
                            const std::vector<TriangleProperties>& properties);

}  // namespace fiberfate
