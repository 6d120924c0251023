// Tests meshing of patches: areas, orientation, shared edges, what lies inside, and errors.
#include "io/patch_mesher.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "base/threads.hpp"

namespace fiberfate {
namespace {

Vec3 doubled_area(const SurfaceMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const auto at = [&mesh](Index point) { return mesh.points[static_cast<std::size_t>(point)]; };
  return (at(b) - at(a)).cross(at(c) - at(a));
}

double area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) sum += 0.5 * doubled_area(mesh, i).norm();
  return sum;
}

/// Counts edges by the number of triangles that meet there.
std::map<int, int> edge_counts(const SurfaceMesh& mesh) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const auto& edge : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)}) ++edges[edge];
  std::map<int, int> counts;
  for (const auto& [edge, triangles] : edges) ++counts[triangles];
  return counts;
}

/// A plate of 60 × 40 mm in the plane z = 0.
PatchedSurface plate() {
  PatchedSurface surface;
  surface.corners = {{0, 0, 0}, {0.06, 0, 0}, {0.06, 0.04, 0}, {0, 0.04, 0}};
  surface.sizes.assign(4, 4e-3);
  surface.patches = {{"plate", {{0, 1, 2, 3}}, {}, {}}};
  return surface;
}

TEST(PatchMesher, FillsAPlateWithUprightTriangles) {
  const SurfaceMesh mesh = mesh_patches(plate());
  EXPECT_NEAR(area(mesh), 0.06 * 0.04, 1e-15);
  EXPECT_GT(mesh.triangles.size(), 200U);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) EXPECT_GT(doubled_area(mesh, i).z(), 0);
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"plate"});
  EXPECT_EQ(edge_counts(mesh).size(), 2U);  // edges of the outline and inner edges
}

TEST(PatchMesher, TheSameInputGivesTheSameMesh) {
  const SurfaceMesh first = mesh_patches(plate()), second = mesh_patches(plate());
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.points, second.points);
}

TEST(PatchMesher, LeavesTheNumberOfThreadsAlone) {
  const int before = thread_count();
  use_threads(3);
  static_cast<void>(mesh_patches(plate()));
  EXPECT_EQ(thread_count(), 3);
  use_threads(before);
}

TEST(PatchMesher, LeavesOpeningsFreeAndPutsPointsWhereAsked) {
  PatchedSurface surface = plate();
  for (const Vec3& corner : {Vec3(0.02, 0.01, 0), Vec3(0.02, 0.02, 0), Vec3(0.03, 0.02, 0),
                             Vec3(0.03, 0.01, 0), Vec3(0.0501, 0.0302, 0)})
    surface.corners.push_back(corner);
  surface.sizes.assign(surface.corners.size(), 4e-3);
  surface.patches[0].loops.push_back({4, 5, 6, 7});
  surface.patches[0].inner_points = {8};
  const SurfaceMesh mesh = mesh_patches(surface);
  EXPECT_NEAR(area(mesh), 0.06 * 0.04 - 0.01 * 0.01, 1e-15);
  EXPECT_TRUE(std::any_of(mesh.points.begin(), mesh.points.end(),
                          [](const Vec3& point) { return point.isApprox(Vec3(0.0501, 0.0302, 0), 1e-12); }));
}

TEST(PatchMesher, PatchesShareTheirEdges) {
  // A rib of 10 mm stands on the plate along y = 0.02.
  PatchedSurface surface = plate();
  for (const Vec3& corner :
       {Vec3(0.01, 0.02, 0), Vec3(0.05, 0.02, 0), Vec3(0.05, 0.02, 0.01), Vec3(0.01, 0.02, 0.01)})
    surface.corners.push_back(corner);
  surface.sizes.assign(surface.corners.size(), 4e-3);
  surface.patches[0].inner_edges = {{4, 5}};
  surface.patches.push_back({"rib", {{4, 5, 6, 7}}, {}, {}});
  const SurfaceMesh mesh = mesh_patches(surface);
  EXPECT_NEAR(area(mesh), 0.06 * 0.04 + 0.04 * 0.01, 1e-15);
  EXPECT_EQ(edge_counts(mesh).at(3), 10);  // 40 mm of foot in steps of 4 mm
  EXPECT_EQ(mesh.region_names.size(), 2U);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const bool upright = std::abs(doubled_area(mesh, i).z()) < 1e-15;
    EXPECT_EQ(mesh.region_names[static_cast<std::size_t>(mesh.regions[i])], upright ? "rib" : "plate");
  }
}

TEST(PatchMesher, RefusesLoopsThatCrossThemselves) {
  PatchedSurface surface = plate();
  surface.patches[0].loops[0] = {0, 2, 1, 3};
  EXPECT_THROW((void)mesh_patches(surface), InputError);
}

TEST(PatchMesher, RefusesSizesBeyondTheMesher) {
  for (const double scale : {1e-300, 1e-150, 1e-14, 1e14, 1e200}) {
    PatchedSurface surface = plate();
    for (Vec3& corner : surface.corners) corner *= scale;
    for (double& size : surface.sizes) size *= scale;
    try {
      EXPECT_NEAR(area(mesh_patches(surface)) / (0.06 * 0.04 * scale * scale), 1, 1e-9) << scale;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("the part cannot be meshed"), std::string::npos) << scale;
    }
  }
}

}  // namespace
}  // namespace fiberfate
