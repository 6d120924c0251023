// Tests the checks of shells and what meshes tell of them.
#include "molding/shell_mesh.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "base/error.hpp"

namespace fiberfate {
namespace {

/// A unit square of two triangles, 2 mm thick.
Shell square() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {0.002, 0.002}, {}, {}};
}

std::string complaint(const Shell& shell) {
  try {
    check_shell(shell);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ShellChecks, ASoundShellPasses) {
  EXPECT_EQ(complaint(square()), "");
}

TEST(ShellChecks, FaultsNameTheTriangleAndTheRemedy) {
  Shell shell = square();
  shell.thickness[1] = 0;
  EXPECT_EQ(
      complaint(shell),
      "triangle 1 at (0.333333, 0.666667, 0) m has a thickness of 0 m: give a thickness above zero to its "
      "region or element");
  shell = square();
  shell.triangles[1] = {0, 3, 2};
  EXPECT_EQ(
      complaint(shell),
      "triangles 0 and 1 at (0.5, 0.5, 0) m are turned opposite ways: orient the surface: reverse the "
      "nodes of one of them; a band that is twisted by half a turn has one side only, and cannot be filled");
  shell = square();
  shell.nodes[3] = {0.5, 0.5, 0};
  EXPECT_NE(complaint(shell).find("triangle 1"), std::string::npos);
  EXPECT_NE(complaint(shell).find("degenerate"), std::string::npos);
  shell = square();
  shell.nodes.push_back({5, 0, 0});
  EXPECT_EQ(complaint(shell), "node 4 at (5, 0, 0) m belongs to no triangle: remove it");
  shell = square();
  shell.triangles[1][2] = 9;
  EXPECT_NE(complaint(shell).find("triangle 1 names node 9 of 4"), std::string::npos);
  shell = square();
  shell.thickness.pop_back();
  EXPECT_NE(complaint(shell).find("2 triangles and 1 thicknesses"), std::string::npos);
}

TEST(ShellChecks, PiecesMustHangTogether) {
  Shell shell = square();
  for (const double x : {3.0, 4.0}) shell.nodes.push_back({x, 0, 0});
  shell.nodes.push_back({3, 1, 0});
  shell.triangles.push_back({4, 5, 6});
  shell.thickness.push_back(0.002);
  EXPECT_NE(complaint(shell).find("hangs on nothing"), std::string::npos);
}

/// Two strips that lie edge to edge hang together by one node of the edge; at the others the mesh is open.
TEST(ShellChecks, SeamsMustBeClosed) {
  Shell shell = square();
  shell.nodes.push_back({1 + 1e-9, 0, 0});  // where node 1 is
  for (const double y : {0.0, 1.0}) shell.nodes.push_back({2, y, 0});
  shell.triangles.push_back({4, 5, 6});
  shell.triangles.push_back({4, 6, 2});
  shell.thickness.assign(4, 0.002);
  EXPECT_NE(complaint(shell).find("nodes 1 and 4 both lie at (1, 0, 0) m: the surface is open between them: "
                                  "merge nodes that coincide"),
            std::string::npos);
  shell.triangles[2] = {1, 5, 6};
  shell.triangles[3] = {1, 6, 2};
  shell.nodes.erase(shell.nodes.begin() + 4);
  for (auto& triangle : shell.triangles)
    for (Index& node : triangle) node -= node > 4 ? 1 : 0;
  EXPECT_EQ(complaint(shell), "");
}

TEST(ShellChecks, SurfacesMustNotTouchInAPoint) {
  Shell shell = square();
  for (const Vec3& node : {Vec3(2, 1, 0), Vec3(2, 2, 0)}) shell.nodes.push_back(node);
  shell.triangles.push_back({2, 4, 5});
  shell.thickness.assign(3, 0.002);
  EXPECT_NE(complaint(shell).find("touch in nothing but node 2 at (1, 1, 0) m"), std::string::npos);
}

TEST(ShellChecks, SkinsOfSolidsAreRefused) {
  const Shell tetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                             {1, 1, 1, 1}};
  EXPECT_NE(complaint(tetrahedron).find("the surface is closed: it is the skin of a solid"),
            std::string::npos);
}

TEST(ShellChecks, JunctionsAreRefusedUnlessAllowed) {
  Shell shell = square();
  shell.nodes.push_back({0.5, 0.5, 1});
  shell.triangles.push_back({0, 2, 4});
  shell.thickness.push_back(0.002);
  EXPECT_NE(complaint(shell).find("belongs to 3 triangles"), std::string::npos);
  shell.junctions = Junctions::allowed;
  EXPECT_EQ(complaint(shell), "");
  EXPECT_NO_THROW(ShellMesh{shell});
}

TEST(ShellChecks, ManyFaultsAreSummedUp) {
  Shell shell = square();
  for (int i = 0; i < 8; ++i) shell.nodes.push_back({2.0 + i, 0, 0});
  EXPECT_NE(complaint(shell).find("3 more of: unused nodes"), std::string::npos);
}

TEST(ShellMesh, ControlVolumesFillThePart) {
  const ShellMesh mesh(square());
  EXPECT_NEAR(mesh.total_area(), 1, 1e-15);
  EXPECT_NEAR(mesh.total_volume(), 0.002, 1e-17);
  // Voronoi cells of a square's corners are its quarters, whichever way the diagonal runs.
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(mesh.area(i), 0.25, 1e-15);
    EXPECT_NEAR(mesh.thickness(i), 0.002, 1e-17);
    EXPECT_NEAR(mesh.angle(i), std::numbers::pi / 2, 1e-14);
    EXPECT_TRUE(mesh.on_boundary(i));
  }
  EXPECT_EQ(mesh.edges().size(), 5u);
}

TEST(ShellMesh, ObtuseTrianglesGiveHalfToTheirObtuseCorner) {
  Shell shell = {{{0, 0, 0}, {4, 0, 0}, {2, 0.5, 0}}, {{0, 1, 2}}, {1}, {}, {}};
  const ShellMesh mesh(shell);
  EXPECT_NEAR(mesh.area(2), 0.5, 1e-15);
  EXPECT_NEAR(mesh.area(0), 0.25, 1e-15);
}

TEST(ShellMesh, VectorsKeepTheirAngleToTheEdgeAroundABend) {
  // Two squares at a right angle along the edge x = 1.
  Shell shell = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}},
                 {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}},
                 {1, 1, 1, 1},
                 {},
                 {}};
  const ShellMesh mesh(shell);
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    EXPECT_NEAR((mesh.frame(i).transpose() * mesh.frame(i) - Mat3::Identity()).norm(), 0, 1e-14);
    for (const ShellNeighbour& to : mesh.neighbours(i)) {
      EXPECT_NEAR(to.direction.norm(), 1, 1e-14);
      // The way back turns back.
      for (const ShellNeighbour& back : mesh.neighbours(static_cast<std::size_t>(to.node))) {
        if (back.node != static_cast<Index>(i)) continue;
        EXPECT_NEAR(back.turn[0], to.turn[0], 1e-14);
        EXPECT_NEAR(back.turn[1], -to.turn[1], 1e-14);
      }
    }
  }
  // The diagonal of the flat square leaves its corner at 45 degrees, and meets the bend at 45 degrees:
  // unfolded.
  const auto diagonal = [&](std::size_t from, Index to) {
    for (const ShellNeighbour& n : mesh.neighbours(from))
      if (n.node == to) return n.direction;
    return Vec2(0, 0);
  };
  EXPECT_NEAR(std::abs(diagonal(0, 2)[0]), std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(std::abs(diagonal(2, 0)[1]), std::sqrt(0.5), 1e-14);
}

TEST(ShellMesh, FindsTheNearestNode) {
  EXPECT_EQ(ShellMesh(square()).nearest_node({0.9, 0.8, 0.3}), 2u);
}

/// The long diagonal of a kite lies between angles that add up to more than pi: the flow takes the short one,
/// and area, volume and the shell stay what they are.
TEST(ShellMesh, ObtusePairsAreTurned) {
  const Shell kite{
      {{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}, {0.002, 0.00204}, {}, {}};
  const ShellMesh mesh(kite);
  EXPECT_EQ(mesh.turned_edges(), 1u);
  EXPECT_EQ(mesh.shell().triangles, kite.triangles);
  for (const ShellEdge& edge : mesh.edges()) EXPECT_FALSE(edge.first == 0 && edge.second == 1);
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_NEAR(mesh.thickness_of(t), 0.00202, 1e-15);
    const auto& [a, b, c] = mesh.corners(t);
    const Vec3 u = kite.nodes[b] - kite.nodes[a], v = kite.nodes[c] - kite.nodes[a];
    EXPECT_NEAR(u.cross(v)[2], 4, 1e-14);  // the same way round as before
  }
  EXPECT_NEAR(mesh.total_area(), 4, 1e-14);
  EXPECT_NEAR(mesh.total_volume(), 2 * 0.002 + 2 * 0.00204, 1e-15);
}

TEST(ShellMesh, FoldsAndStepsOfTheWallStay) {
  Shell kite{{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}, {0.002, 0.003}, {}, {}};
  EXPECT_EQ(ShellMesh(kite).turned_edges(), 0u);
  kite.thickness[1] = 0.002;
  kite.nodes[3][2] = 0.1;
  EXPECT_EQ(ShellMesh(kite).turned_edges(), 0u);
}

}  // namespace
}  // namespace fiberfate
