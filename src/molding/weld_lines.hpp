// Lines along which fronts have met.
#pragma once

#include <array>
#include <vector>

#include "molding/filling_state.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Whether two full neighbours were reached by fronts that ran against each other: from directions more than
/// 120 degrees apart, each towards the other.
[[nodiscard]] bool fronts_met_between(const FillingState& state, std::size_t node,
                                      const ShellNeighbour& other);
/// Whether fronts met in the control volume of a full node: what came in cancels to less than half of it.
[[nodiscard]] bool fronts_met_in(const ShellMesh& mesh, const FillingState& state, std::size_t node);

/// The ends of a piece of a line, m.
using LinePiece = std::array<Vec3, 2>;

/// Draws the weld lines, a piece a triangle: through nodes in which fronts met and through the middle of
/// edges between which they did.
[[nodiscard]] std::vector<LinePiece> weld_lines(const ShellMesh& mesh, const FillingState& state);

}  // namespace fiberfate
