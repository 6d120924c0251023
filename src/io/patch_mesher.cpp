// Meshes flat patches through Gmsh.
#include "io/patch_mesher.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <cassert>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "io/gmsh_session.hpp"

namespace fiberfate {
namespace {

namespace geo = gmsh::model::geo;
constexpr double frontal_delaunay = 6;  // of Gmsh's Mesh.Algorithm

/// Hands corners and edges to Gmsh once each.
class EdgeBook {
 public:
  explicit EdgeBook(const PatchedSurface& surface) : surface_(surface) {}

  int point(std::size_t corner) {
    const auto found = points_.find(corner);
    if (found != points_.end()) return found->second;
    const Vec3& at = surface_.corners.at(corner);
    return points_[corner] = geo::addPoint(at.x(), at.y(), at.z(), surface_.sizes.at(corner));
  }
  /// Gives the edge from one corner to another: negative when Gmsh knows it in the other direction.
  int edge(std::size_t from, std::size_t to) {
    const auto key = std::minmax(from, to);
    auto found = edges_.find(key);
    if (found == edges_.end())
      found = edges_.emplace(key, geo::addLine(point(key.first), point(key.second))).first;
    return from < to ? found->second : -found->second;
  }

 private:
  const PatchedSurface& surface_;
  std::map<std::size_t, int> points_;
  std::map<std::pair<std::size_t, std::size_t>, int> edges_;
};

int add_loop(EdgeBook& book, const std::vector<std::size_t>& corners) {
  std::vector<int> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edges.push_back(book.edge(corners[i], corners[(i + 1) % corners.size()]));
  return geo::addCurveLoop(edges);
}

int add_patch(EdgeBook& book, const Patch& patch) {
  std::vector<int> loops;
  for (const std::vector<std::size_t>& loop : patch.loops) loops.push_back(add_loop(book, loop));
  for (const std::size_t corner : patch.inner_points) book.point(corner);
  for (const auto& [from, to] : patch.inner_edges) book.edge(from, to);
  return geo::addPlaneSurface(loops);
}

void embed(EdgeBook& book, const Patch& patch, int surface) {
  std::vector<int> points, edges;
  for (const std::size_t corner : patch.inner_points) points.push_back(book.point(corner));
  for (const auto& [from, to] : patch.inner_edges) edges.push_back(std::abs(book.edge(from, to)));
  if (!points.empty()) gmsh::model::mesh::embed(0, points, 2, surface);
  if (!edges.empty()) gmsh::model::mesh::embed(1, edges, 2, surface);
}

void name_regions(const PatchedSurface& surface, const std::vector<int>& surfaces) {
  std::map<std::string, std::vector<int>> regions;
  for (std::size_t i = 0; i < surfaces.size(); ++i) regions[surface.patches[i].region].push_back(surfaces[i]);
  for (const auto& [region, members] : regions)
    gmsh::model::setPhysicalName(2, gmsh::model::addPhysicalGroup(2, members), region);
}

void generate(const PatchedSurface& surface) {
  gmsh::option::setNumber("Mesh.Algorithm", frontal_delaunay);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 1);
  gmsh::model::add("part");
  EdgeBook book(surface);
  std::vector<int> surfaces;
  for (const Patch& patch : surface.patches) surfaces.push_back(add_patch(book, patch));
  geo::synchronize();
  for (std::size_t i = 0; i < surfaces.size(); ++i) embed(book, surface.patches[i], surfaces[i]);
  name_regions(surface, surfaces);
  gmsh::model::mesh::generate(2);
}

}  // namespace

SurfaceMesh mesh_patches(const PatchedSurface& surface) {
  assert(surface.corners.size() == surface.sizes.size() && !surface.patches.empty());
  const GmshSession session;
  try {
    generate(surface);
  } catch (const std::string& reason) {
    throw InputError(fmt::format("the part cannot be meshed: {}", reason),
                     "check its dimensions: edges must not cross and openings must lie inside");
  }
  return take_triangles("the part", 1);
}

}  // namespace fiberfate
