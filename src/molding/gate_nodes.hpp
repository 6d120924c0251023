// Finds the nodes that a gate feeds.
#pragma once

#include <span>
#include <vector>

#include "molding/gate.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// How far the ends of a gate lie off the surface of the triangles, m.
[[nodiscard]] double distance_from_part(const Gate& gate, const ShellMesh& mesh);

/// Finds the nodes within the gate's radius of its line, in rising order; the nearest node when there are
/// none.
[[nodiscard]] std::vector<Index> nodes_of(const Gate& gate, const ShellMesh& mesh);

/// Describes an edge that leaves a round gate.
struct GateEdge {
  Index edge = 0;
  Index outside = 0;  ///< the node that the edge leads to
  double scale = 1;   ///< what the gate's size makes of the conductance
  double start = 0;   ///< distance of the edge's node in the gate from the gate's centre, m
  double end = 0;     ///< of the node outside, m
  double radius = 0;  ///< of the gate, m

  /// How much more the edge conducts where the front stands on it, in a control volume that is
  /// filled to a share: ln(r_end/r)/ln(r_front/r).
  [[nodiscard]] double front_factor(double filled) const;
};

/// Finds the edges that leave a round gate, with scale = theta_e/(w_e ln(r_b/r)): in the radial field around
/// the gate, in which the pressure of its nodes is that at its radius r, each edge carries what passes its
/// dual face. theta_e is the angle under which that face is seen from the centre of the gate, w_e = cot/2 +
/// cot/2, r_b the distance of the node outside. None for film gates.
[[nodiscard]] std::vector<GateEdge> edges_of_round_gate(const Gate& gate, std::span<const Index> nodes,
                                                        const ShellMesh& mesh);

}  // namespace fiberfate
