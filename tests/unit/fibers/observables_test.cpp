// Tests the measures of a population on populations whose measures are known.
#include "fibers/observables.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "unit/fibers/sample_fibers.hpp"

namespace fiberfate {
namespace {

/// One fiber of three rods along x (3e-4 m) and one of one rod along y (1e-4 m).
FiberState two_fibers() {
  FiberState state = empty_state();
  append_straight(state, Vec3::Zero(), Vec3(1e-4, 0, 0), 3);
  append_straight(state, Vec3(0, 0, 5e-4), Vec3(0, 1e-4, 0), 1);
  return state;
}

TEST(MeanLengths, FollowTheirDefinitions) {
  const MeanLengths lengths = mean_lengths(two_fibers());
  EXPECT_NEAR(lengths.number_average, 2e-4, 1e-18);
  EXPECT_NEAR(lengths.weight_average, (9 + 1) / 4.0 * 1e-4, 1e-18);
}

TEST(OrientationTensor, WeighsByLengthOrByFiber) {
  const Mat3 by_length = orientation_tensor(two_fibers(), Weighting::length);
  EXPECT_TRUE(by_length.isApprox(Vec3(0.75, 0.25, 0).asDiagonal().toDenseMatrix(), 1e-14));
  const Mat3 by_number = orientation_tensor(two_fibers(), Weighting::number);
  EXPECT_TRUE(by_number.isApprox(Vec3(0.5, 0.5, 0).asDiagonal().toDenseMatrix(), 1e-14));
}

TEST(OrientationTensor, SharesABentFiberBetweenItsRods) {
  FiberState state = empty_state();
  const std::array<Vec3, 3> bent = {Vec3(0, 0, 0), Vec3(3e-4, 0, 0), Vec3(3e-4, 0, 1e-4)};
  append_fiber(state, {bent, 0});
  append_straight(state, Vec3(0, 5e-4, 0), Vec3(0, 4e-4, 0), 1);
  const Mat3 expected = Vec3(0.375, 0.5, 0.125).asDiagonal();
  EXPECT_TRUE(orientation_tensor(state, Weighting::number).isApprox(expected, 1e-14));
}

TEST(OrientationTensor4, ContractsToTheSecondOrderTensor) {
  FiberState state = empty_state();
  append_straight(state, Vec3::Zero(), Vec3(1e-4, 2e-4, -1e-4), 2);
  append_straight(state, Vec3::Zero(), Vec3(-3e-4, 1e-4, 2e-4), 3);
  for (const Weighting weighting : {Weighting::length, Weighting::number}) {
    const auto a4 = orientation_tensor4(state, weighting);
    const Mat3 a2 = orientation_tensor(state, weighting);
    // A_ijkk = A_ij; the rows stand for 11, 22, 33, 23, 31, 12.
    const Eigen::Matrix<double, 6, 1> contracted = a4.leftCols<3>().rowwise().sum();
    const std::array<double, 6> expected = {a2(0, 0), a2(1, 1), a2(2, 2), a2(1, 2), a2(2, 0), a2(0, 1)};
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(contracted[i], expected[static_cast<std::size_t>(i)], 1e-14);
    EXPECT_NEAR(a4(3, 3), a4(1, 2), 1e-15) << "A_2323 = A_2233";
  }
}

TEST(LengthHistogram, CountsOrSumsWithTheLastBinClosed) {
  FiberState state = empty_state();
  append_straight(state, Vec3::Zero(), Vec3(1e-4, 0, 0), 1);
  append_straight(state, Vec3::Zero(), Vec3(2.5e-4, 0, 0), 1);
  append_straight(state, Vec3::Zero(), Vec3(4e-4, 0, 0), 1);
  append_straight(state, Vec3::Zero(), Vec3(9e-4, 0, 0), 1);
  const std::array<double, 3> edges = {1e-4, 2.5e-4, 4e-4};
  EXPECT_EQ(length_histogram(state, edges, Weighting::number), (std::vector<double>{1, 2}));
  const std::vector<double> sums = length_histogram(state, edges, Weighting::length);
  EXPECT_DOUBLE_EQ(sums[0], 1e-4);
  EXPECT_DOUBLE_EQ(sums[1], 6.5e-4);
}

TEST(LengthHistogram, RefusesEdgesThatMakeNoBins) {
  for (const std::vector<double>& edges : {std::vector<double>{},
                                           {1e-3},
                                           {1e-3, 0},
                                           {0, 0},
                                           {0, std::numeric_limits<double>::quiet_NaN(), 1e-3}})
    EXPECT_THROW(static_cast<void>(length_histogram(empty_state(), edges, Weighting::number)), InputError);
}

TEST(HingeRadii, AreThoseOfTheCircleThroughTheNodes) {
  FiberState state = empty_state();
  const double radius = 250e-6;
  std::vector<Vec3> arc;
  for (int k = 0; k < 6; ++k) arc.emplace_back(radius * std::cos(0.3 * k), radius * std::sin(0.3 * k), 0);
  append_fiber(state, {arc, 0});
  append_straight(state, Vec3::Zero(), Vec3(1e-4, 0, 0), 3);
  const std::vector<double> radii = hinge_radii(state);
  ASSERT_EQ(radii.size(), 6U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(radii[i], radius, 1e-12 * radius);
  EXPECT_EQ(radii[4], std::numeric_limits<double>::infinity());
  EXPECT_NEAR(minimum_radius(state), radius, 1e-12 * radius);
  EXPECT_EQ(count_hinges(state, 200e-6, 260e-6), 4);
  EXPECT_EQ(count_hinges(state, 260e-6, std::numeric_limits<double>::infinity()), 0);
}

TEST(MinimumRadius, IsInfiniteWithoutHinges) {
  FiberState state = empty_state();
  append_straight(state, Vec3::Zero(), Vec3(1e-4, 0, 0), 1);
  EXPECT_EQ(minimum_radius(state), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace fiberfate
