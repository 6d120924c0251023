// How far a mesh can be trusted: how fine it is seen from the gates, and what its obtuse triangles cut off.
#pragma once

#include <span>
#include <vector>

#include "base/error.hpp"
#include "molding/gate.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// What a mesh costs in accuracy.
struct MeshQuality {
  /// Edges between the nodes of the nearest gate and the node that is farthest from all gates: cells along
  /// the longest way of the melt.
  std::size_t reach = 0;
  /// Share of the weights cot + cot of all edges, by size, that is negative: such edges lie between obtuse
  /// triangles that ShellMesh could not turn into others, and conduct nothing; the edges around them make up
  /// for it along walls and folds, not across.
  double cut_off = 0;

  /// By how much the pressure is wrong, rms over the filling and of the largest: 0.3/reach^1.5 and
  /// what is cut off, as strips of 2 to 40 cells and of zigzag rows show (tests/physics/molding); with walls
  /// of obtuse triangles it is a tenth of that to 1.5 times as much.
  [[nodiscard]] double pressure_error() const;
};

[[nodiscard]] MeshQuality quality_of(const ShellMesh& mesh, std::span<const Gate> gates);

/// Appends what makes a mesh useless: fewer than four edges from the gates to the farthest node, or a
/// twentieth and more of its weights cut off, which make pressures wrong by some 4 and 5 %.
void check_quality(const ShellMesh& mesh, std::span<const Gate> gates, std::vector<InputProblem>& problems);

}  // namespace fiberfate
