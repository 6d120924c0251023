// A square plate for tests of what needs a mesh.
#pragma once

#include "molding/shell_mesh.hpp"

namespace fiberfate::test {

/// Meshes a square of side `size` (m), 2 mm thick, with its corner at the origin: cells x cells squares of
/// two triangles.
inline ShellMesh plate(double size, Index cells) {
  Shell shell;
  for (Index j = 0; j <= cells; ++j)
    for (Index i = 0; i <= cells; ++i) shell.nodes.emplace_back(size * i / cells, size * j / cells, 0);
  for (Index j = 0; j < cells; ++j)
    for (Index i = 0; i < cells; ++i) {
      const Index a = j * (cells + 1) + i, d = a + cells + 1;
      shell.triangles.push_back({a, a + 1, d + 1});
      shell.triangles.push_back({a, d + 1, d});
    }
  shell.thickness.assign(shell.triangles.size(), 0.002);
  return ShellMesh(shell);
}

}  // namespace fiberfate::test
