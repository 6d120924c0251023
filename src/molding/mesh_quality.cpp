// Measures meshes against what filling needs.
#include "molding/mesh_quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "molding/gate_nodes.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t least_reach = 4;
constexpr double most_cut_off = 0.05;

std::size_t reach_of(const ShellMesh& mesh, std::span<const Gate> gates) {
  std::vector<char> reached(mesh.node_count(), 0);
  std::vector<Index> ring, next;
  const auto add = [&](std::vector<Index>& nodes, Index node) {
    if (std::exchange(reached[node], 1) == 0) nodes.push_back(node);
  };
  for (const Gate& gate : gates)
    for (const Index node : nodes_of(gate, mesh)) add(ring, node);
  std::size_t reach = 0;
  while (!ring.empty()) {
    next.clear();
    for (const Index node : ring)
      for (const ShellNeighbour& to : mesh.neighbours(node)) add(next, to.node);
    if (!next.empty()) ++reach;
    std::swap(ring, next);
  }
  return reach;
}

}  // namespace

double MeshQuality::pressure_error() const {
  return 0.3 / std::pow(static_cast<double>(reach), 1.5) + cut_off;
}

MeshQuality quality_of(const ShellMesh& mesh, std::span<const Gate> gates) {
  return {reach_of(mesh, gates), mesh.cut_off()};
}

void check_quality(const ShellMesh& mesh, std::span<const Gate> gates, std::vector<InputProblem>& problems) {
  const MeshQuality quality = quality_of(mesh, gates);
  if (quality.reach < least_reach)
    problems.push_back({"", 0, 0, "mesh", "",
                        fmt::format("its {} triangles are too few: no node is more than {} edges from a gate",
                                    mesh.triangle_count(), quality.reach),
                        fmt::format("mesh the part so that melt passes {} edges and more on its longest way, "
                                    "better 20",
                                    least_reach)});
  if (quality.cut_off > most_cut_off)
    problems.push_back(
        {"", 0, 0, "mesh", "",
         fmt::format("{:.0f} % of what leads the flow lies between obtuse triangles and is lost: "
                     "pressures would be wrong by some {:.0f} %",
                     100 * quality.cut_off, 100 * quality.cut_off),
         "make a Delaunay mesh"});
}

}  // namespace fiberfate
