// Properties of a filled part as its case gives them, and how they are written.
#pragma once

#include <string>
#include <vector>

#include "io/poly_frame.hpp"
#include "molding/part_properties.hpp"
#include "studies/molding/fields.hpp"

namespace fiberfate {

/// Whether a case gives what properties need: an orientation law and lengths.
[[nodiscard]] bool has_properties(const MoldingCase& values);
/// Takes from a case what its part is made of.
[[nodiscard]] PartSolid solid_of(const MoldingCase& values);

/// Makes a frame of the properties.
[[nodiscard]] PolyFrame properties_frame(const Filling& filling,
                                         const std::vector<TriangleProperties>& properties);

/// Solvers of structures. Abaqus has triangles of three nodes that bend (S3); CalculiX makes solid
/// wedges of those, which bend half as far as they should, and takes six nodes (S6).
enum class StructuralSolver { abaqus, calculix };

/// Writes the part for a solver of structures: nodes, triangles, and for each the plies across its thickness
/// with their material axes, engineering constants and expansion; SI units. Raises StorageError.
void write_structural_input(const std::string& path, const Shell& shell, const std::vector<Ply>& plies,
                            StructuralSolver solver);

}  // namespace fiberfate
