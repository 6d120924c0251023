// Tests how fibers are added, measured, split and wrapped.
#include "fibers/state.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "unit/fibers/sample_fibers.hpp"

namespace fiberfate {
namespace {

TEST(FiberMaterial, HasTheBendingStiffnessOfASolidRod) {
  const FiberMaterial glass{9.5e-6, 73e9, 2550};
  EXPECT_NEAR(glass.bending_stiffness(), 73e9 * pi * std::pow(19e-6, 4) / 64, 1e-20);
}

TEST(AppendFiber, RefusesWhatIsNoFiber) {
  FiberState state = empty_state();
  const std::array<Vec3, 1> point = {Vec3::Zero()};
  const std::array<Vec3, 2> doubled = {Vec3::Zero(), Vec3::Zero()};
  const std::array<Vec3, 2> rod = {Vec3::Zero(), Vec3(1e-4, 0, 0)};
  EXPECT_THROW(append_fiber(state, {point, 0}), InputError);
  EXPECT_THROW(append_fiber(state, {doubled, 0}), InputError);
  EXPECT_THROW(append_fiber(state, {rod, 1}), InputError);
}

TEST(FiberState, NumbersNodesAndRods) {
  FiberState state = empty_state();
  append_straight(state, Vec3::Zero(), Vec3(1e-4, 0, 0), 3);
  append_straight(state, Vec3::Zero(), Vec3(0, 1e-4, 0), 2);
  EXPECT_EQ(state.fiber_count(), 2);
  EXPECT_EQ(state.node_count(), 7);
  EXPECT_EQ(state.rod_count(), 5);
  EXPECT_EQ(state.rod_count(FiberIndex(1)), 2);
  EXPECT_EQ(state.birth_id[FiberIndex(1)], 1U);
  EXPECT_EQ(state.rod_length[RodIndex(3)], 0.0) << "the last node owns no rod";
  EXPECT_NEAR(fiber_length(state, FiberIndex(0)), 3e-4, 1e-18);
  EXPECT_TRUE(fiber_centroid(state, FiberIndex(0)).isApprox(Vec3(1.5e-4, 0, 0), 1e-14));
}

TEST(NumberByHeight, KeepsFibersAndSortsThemAcrossTheShear) {
  FiberState state = empty_state();
  state.materials.push_back({3e-6, 230e9, 1800});
  append_straight(state, Vec3(0, 9e-4, 0), Vec3(1e-4, 0, 0), 3);
  append_straight(state, Vec3(0, -7e-4, 0), Vec3(0, 0, 1e-4), 2);  // its image is at 3e-4
  const std::array<Vec3, 2> carbon = {Vec3(0, 5e-4, 0), Vec3(1e-4, 5e-4, 0)};
  append_fiber(state, {carbon, 1});
  number_by_height(state);
  ASSERT_EQ(state.fiber_count(), 3);
  EXPECT_EQ(state.position[NodeIndex(0)], Vec3(0, -7e-4, 0));
  EXPECT_EQ(state.rod_count(FiberIndex(0)), 2);
  EXPECT_EQ(state.position[state.begin_node(FiberIndex(1))], carbon[0]);
  EXPECT_EQ(state.material(FiberIndex(1)).radius, 3e-6);
  EXPECT_EQ(state.rod_count(FiberIndex(2)), 3);
  EXPECT_EQ(state.birth_id, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(HingeRadius, OfEqualRodsIsLengthOverTwiceTheSineOfHalfTheTurn) {
  const double turn = 0.4;
  const double length = 1e-4;
  const Vec3 after(length + length * std::cos(turn), length * std::sin(turn), 0);
  EXPECT_NEAR(hinge_radius(Vec3::Zero(), Vec3(length, 0, 0), after), length / (2 * std::sin(turn / 2)),
              1e-16);
}

TEST(HingeRadius, IsInfiniteOnALineAndZeroWhereAFiberDoublesBack) {
  EXPECT_EQ(hinge_radius(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(3, 0, 0)),
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(hinge_radius(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)), 0.0);
}

TEST(SplitFibers, ConservesRodsLengthVelocitiesAndOrigin) {
  FiberState state = empty_state();
  append_straight(state, Vec3::Zero(), Vec3(1e-4, 0, 0), 5);
  append_straight(state, Vec3(0, 5e-4, 0), Vec3(0, 1e-4, 0), 2);
  for (const NodeIndex k : state.nodes()) state.relative_velocity[k] = Vec3(k.value(), 0, 0);
  const std::array<NodeIndex, 2> nodes = {NodeIndex(2), NodeIndex(3)};
  split_fibers(state, nodes);
  EXPECT_EQ(state.fiber_count(), 4);
  EXPECT_EQ(state.rod_count(), 7);
  EXPECT_EQ(state.breaks, 2);
  EXPECT_EQ(state.birth_id, (std::vector<std::uint32_t>{0, 0, 0, 1}));
  EXPECT_EQ(state.birth_node, (std::vector<std::uint32_t>{0, 2, 3, 0}));
  EXPECT_EQ(state.touches_previous, (std::vector<std::uint8_t>{0, 1, 1, 0}));
  const std::span<const Index> first_node = numbers(state.first_node);
  EXPECT_EQ(std::vector<Index>(first_node.begin(), first_node.end()), (std::vector<Index>{0, 3, 5, 8, 11}));
  double length = 0;
  for (const FiberIndex fiber : state.fibers()) length += fiber_length(state, fiber);
  EXPECT_NEAR(length, 7e-4, 1e-18);
  EXPECT_EQ(state.relative_velocity[NodeIndex(2)][0], 2.0);
  EXPECT_EQ(state.relative_velocity[NodeIndex(3)][0], 2.0) << "the node of a break is doubled";
  EXPECT_EQ(state.relative_velocity[NodeIndex(10)][0], 8.0);
}

TEST(WrapFibers, MovesCentroidsIntoTheCellAndKeepsShapes) {
  FiberState state = empty_state();
  append_straight(state, Vec3(2.3e-3, -0.2e-3, 0.5e-3), Vec3(1e-4, 0, 0), 2);
  wrap_fibers(state);
  EXPECT_TRUE(fiber_centroid(state, FiberIndex(0)).isApprox(Vec3(0.4e-3, 0.8e-3, 0.5e-3), 1e-12));
  EXPECT_TRUE(
      (state.position[NodeIndex(2)] - state.position[NodeIndex(0)]).isApprox(Vec3(2e-4, 0, 0), 1e-12));
}

TEST(VolumeFraction, IsThatOfCylinders) {
  FiberState state = empty_state();
  append_straight(state, Vec3::Zero(), Vec3(1e-4, 0, 0), 5);
  EXPECT_NEAR(volume_fraction(state), pi * 9.5e-6 * 9.5e-6 * 5e-4 / 1e-9, 1e-15);
}

}  // namespace
}  // namespace fiberfate
