// Finds the nodes that a gate feeds.
#pragma once

#include <span>
#include <vector>

#include "molding/gate.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Tells how far the ends of a gate lie off the surface of the triangles, m.
[[nodiscard]] double distance_from_part(const Gate& gate, const ShellMesh& mesh);

/// Finds the nodes within the gate's radius of its line, in rising order; the nearest node when there are
/// none.
[[nodiscard]] std::vector<Index> nodes_of(const Gate& gate, const ShellMesh& mesh);

/// Multiplies the scales of the edges that leave a round gate by a = theta / sum of cot/2 ln(r_j/r), so that
/// the pressure of the gate's nodes is that at its radius r in the radial field around it: theta is the angle
/// of the part around the gate, r_j the distances of the nodes around.
void scale_edges_of_round_gate(const Gate& gate, std::span<const Index> nodes, const ShellMesh& mesh,
                               std::span<double> scales);

}  // namespace fiberfate
