// Tests that fibers become frames and fibers again.
#include "results/fiber_frame.hpp"

#include <gtest/gtest.h>

#include <array>

namespace fiberfate {
namespace {

FiberState two_fibers() {
  FiberState state;
  state.materials = {{9.5e-6, 73e9, 2550}, {5e-6, 73e9, 2550}};
  state.cell = rectangular_cell(Vec3(1e-3, 2e-3, 3e-3));
  state.cell.lattice(0, 1) = 0.4e-3;
  const std::array<Vec3, 3> bent = {Vec3(0, 0, 0), Vec3(1e-4, 0, 0), Vec3(1e-4, 1e-4, 0)};
  const std::array<Vec3, 2> straight = {Vec3(0, 0, 5e-4), Vec3(0, 0, 7e-4)};
  append_fiber(state, {bent, 0});
  append_fiber(state, {straight, 1});
  state.birth_id = {4, 9};
  state.birth_node = {2, 7};
  state.relative_velocity[NodeIndex(1)] = Vec3(1, 2, 3);
  state.time = 0.75;
  return state;
}

TEST(FiberFrame, HoldsTheMeasuresOfNodesAndFibers) {
  const PolyFrame frame = fiber_frame(two_fibers());
  EXPECT_EQ(frame.time, 0.75);
  EXPECT_EQ(frame.offsets, (std::vector<std::int64_t>{0, 3, 5}));
  const std::vector<double> curvature = numbers_of(frame.point_data, "curvature");
  // The circle through three corners of a square of side 1e-4 m has the radius of half its diagonal.
  EXPECT_NEAR(curvature[1], 1 / (0.5e-4 * std::sqrt(2.0)), 1e-2);
  EXPECT_EQ(curvature[0], 0);
  EXPECT_EQ(curvature[4], 0);
  EXPECT_EQ(numbers_of(frame.point_data, "relative_velocity")[5], 3);
  EXPECT_NEAR(numbers_of(frame.cell_data, "length")[0], 2e-4, 1e-10);
  EXPECT_EQ(numbers_of(frame.cell_data, "birth_id"), (std::vector<double>{4, 9}));
  EXPECT_EQ(numbers_of(frame.frame_data, "lattice")[1], 0.4e-3) << "row 1, column 2: the tilt";
}

TEST(FiberFrame, BecomesFibersAgain) {
  const FiberState state = two_fibers();
  const FiberState again = fibers_of(fiber_frame(state));
  EXPECT_EQ(again.position, state.position);
  EXPECT_EQ(again.first_node, state.first_node);
  EXPECT_EQ(again.birth_id, state.birth_id);
  EXPECT_EQ(again.birth_node, state.birth_node);
  EXPECT_EQ(again.cell.lattice, state.cell.lattice);
  EXPECT_EQ(again.material(FiberIndex(1)).radius, 5e-6);
}

}  // namespace
}  // namespace fiberfate
