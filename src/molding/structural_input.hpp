// Parts with their properties in the language of structural solvers.
#pragma once

#include <string>
#include <vector>

#include "molding/part_properties.hpp"
#include "molding/shell.hpp"

namespace fiberfate {

/// Solvers of structures. Abaqus has triangles of three nodes that bend (S3); CalculiX makes solid
/// wedges of those, which bend half as far as they should, and takes six nodes (S6).
enum class StructuralSolver { abaqus, calculix };

/// The input of a solver: nodes, triangles, and for each the plies across its thickness with their material
/// axes, engineering constants and expansion; SI units.
[[nodiscard]] std::string structural_input(const Shell& shell, const std::vector<Ply>& plies,
                                           StructuralSolver solver);

}  // namespace fiberfate
