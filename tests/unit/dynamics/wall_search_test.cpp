// Tests which nodes are found near walls, and how high above them.
#include "dynamics/wall_search.hpp"

#include <gtest/gtest.h>

namespace fiberfate {
namespace {

FiberState fiber_between_walls(const std::vector<Vec3>& nodes) {
  FiberState state;
  state.cell = rectangular_cell(Vec3(1e-3, 2e-3, 1e-3));
  state.cell.boundary[1] = Boundary::walls;
  state.materials = {{.radius = 1e-5, .youngs_modulus = 73e9, .density = 2550}};
  append_fiber(state, {.nodes = nodes, .material_id = 0});
  return state;
}

TEST(FindWallContacts, MeasuresHeightsAboveBothWalls) {
  const auto walls =
      find_wall_contacts(fiber_between_walls({{0, 1.2e-5, 0}, {1e-4, 1e-3, 0}, {2e-4, 1.99e-3, 0}}));
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls[0].node, NodeIndex(0));
  EXPECT_EQ(walls[0].rod, RodIndex(0));
  EXPECT_NEAR(walls[0].height, 1.2e-5, 1e-18);
  EXPECT_LT((walls[0].normal - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_EQ(walls[1].node, NodeIndex(2));
  EXPECT_EQ(walls[1].rod, RodIndex(1));
  EXPECT_NEAR(walls[1].height, 1e-5, 1e-17);
  EXPECT_LT((walls[1].normal + Vec3::UnitY()).norm(), 1e-15);
}

TEST(FindWallContacts, FindsNoneInAPeriodicCell) {
  FiberState state = fiber_between_walls({{0, 1e-5, 0}, {1e-4, 1e-5, 0}});
  state.cell.boundary[1] = Boundary::periodic;
  EXPECT_TRUE(find_wall_contacts(state).empty());
}

}  // namespace
}  // namespace fiberfate
