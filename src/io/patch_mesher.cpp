// Meshes flat patches through Gmsh.
#include "io/patch_mesher.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "io/gmsh_process.hpp"
#include "io/patch_checks.hpp"

namespace fiberfate {
namespace {

constexpr double frontal_delaunay = 6;    // of Gmsh's Mesh.Algorithm
constexpr double longest_meshing = 1800;  // s; a million triangles take a minute

/// Hands corners and edges to Gmsh once each.
class EdgeBook {
 public:
  EdgeBook(const GmshLibrary& gmsh, const PatchedSurface& surface) : gmsh_(gmsh), surface_(surface) {}

  int point(std::size_t corner) {
    const auto found = points_.find(corner);
    if (found != points_.end()) return found->second;
    const Vec3& at = surface_.corners.at(corner);
    return points_[corner] =
               gmsh_.call(gmsh_.add_point, at.x(), at.y(), at.z(), surface_.sizes.at(corner), -1);
  }
  /// Gives the edge from one corner to another: negative when Gmsh knows it in the other direction.
  int edge(std::size_t from, std::size_t to) {
    const auto key = std::minmax(from, to);
    auto found = edges_.find(key);
    if (found == edges_.end())
      found = edges_.emplace(key, gmsh_.call(gmsh_.add_line, point(key.first), point(key.second), -1)).first;
    return from < to ? found->second : -found->second;
  }

 private:
  const GmshLibrary& gmsh_;
  const PatchedSurface& surface_;
  std::map<std::size_t, int> points_;
  std::map<std::pair<std::size_t, std::size_t>, int> edges_;
};

int add_loop(const GmshLibrary& gmsh, EdgeBook& book, const std::vector<std::size_t>& corners) {
  std::vector<int> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edges.push_back(book.edge(corners[i], corners[(i + 1) % corners.size()]));
  constexpr int as_given = 0;
  return gmsh.call(gmsh.add_loop, edges.data(), edges.size(), -1, as_given);
}

int add_patch(const GmshLibrary& gmsh, EdgeBook& book, const Patch& patch) {
  std::vector<int> loops;
  for (const std::vector<std::size_t>& loop : patch.loops) loops.push_back(add_loop(gmsh, book, loop));
  for (const std::size_t corner : patch.inner_points) book.point(corner);
  for (const auto& [from, to] : patch.inner_edges) book.edge(from, to);
  return gmsh.call(gmsh.add_surface, loops.data(), loops.size(), -1);
}

void embed(const GmshLibrary& gmsh, EdgeBook& book, const Patch& patch, int surface) {
  std::vector<int> points, edges;
  for (const std::size_t corner : patch.inner_points) points.push_back(book.point(corner));
  for (const auto& [from, to] : patch.inner_edges) edges.push_back(std::abs(book.edge(from, to)));
  if (!points.empty()) gmsh.call(gmsh.embed, 0, points.data(), points.size(), 2, surface);
  if (!edges.empty()) gmsh.call(gmsh.embed, 1, edges.data(), edges.size(), 2, surface);
}

void name_regions(const GmshLibrary& gmsh, const PatchedSurface& surface, const std::vector<int>& surfaces) {
  std::map<std::string, std::vector<int>> regions;
  for (std::size_t i = 0; i < surfaces.size(); ++i) regions[surface.patches[i].region].push_back(surfaces[i]);
  for (auto& [region, members] : regions) {
    const int group = gmsh.call(gmsh.add_group, 2, members.data(), members.size(), -1);
    gmsh.call(gmsh.name_group, 2, group, region.c_str());
  }
}

void generate(const GmshLibrary& gmsh, const PatchedSurface& surface) {
  gmsh.call(gmsh.set_option, "Mesh.Algorithm", frontal_delaunay);
  gmsh.call(gmsh.add_model, "part");
  EdgeBook book(gmsh, surface);
  std::vector<int> surfaces;
  for (const Patch& patch : surface.patches) surfaces.push_back(add_patch(gmsh, book, patch));
  gmsh.call(gmsh.synchronize);
  for (std::size_t i = 0; i < surfaces.size(); ++i) embed(gmsh, book, surface.patches[i], surfaces[i]);
  name_regions(gmsh, surface, surfaces);
  gmsh.call(gmsh.generate, 2);
}

}  // namespace

SurfaceMesh mesh_patches(const PatchedSurface& surface) {
  assert(surface.corners.size() == surface.sizes.size() && !surface.patches.empty());
  check_patches(surface);
  const GmshTask task = {"the part cannot be meshed",
                         "check its dimensions: edges must not cross and openings must lie inside",
                         longest_meshing};
  return surface_from_gmsh(task, [&](const GmshSession& session) {
    generate(session.library(), surface);
    return take_triangles(session, "the part", 1);
  });
}

}  // namespace fiberfate
