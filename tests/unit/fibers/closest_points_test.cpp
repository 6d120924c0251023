// Tests the closest points of two rods against an exhaustive minimum over the square's inside, edges and
// corners.
#include "fibers/closest_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace fiberfate {
namespace {

Vec3 random_point(std::uint32_t which, std::uint32_t trial) {
  const auto u = uniform4(7, RandomStream::noise, {which, trial, 0});
  return {u[0] - 0.5, u[1] - 0.5, u[2] - 0.5};
}

double distance_to_segment(const Vec3& point, const Segment& segment) {
  const Vec3 along = segment.end - segment.begin;
  const double s = along.squaredNorm() > 0 ? (point - segment.begin).dot(along) / along.squaredNorm() : 0.0;
  return (point - segment.begin - std::clamp(s, 0.0, 1.0) * along).norm();
}

/// Smallest distance over many points of the first segment: an upper bound, at most `resolution` above the
/// minimum.
double scanned_distance(const Segment& first, const Segment& second, int points) {
  double nearest = 1e300;
  for (int i = 0; i <= points; ++i) {
    const double s = static_cast<double>(i) / points;
    nearest = std::min(nearest, distance_to_segment(first.begin + s * (first.end - first.begin), second));
  }
  return nearest;
}

void expect_consistent(const Segment& first, const Segment& second, const ClosestPoints& found) {
  EXPECT_GE(found.s, 0);
  EXPECT_LE(found.s, 1);
  EXPECT_GE(found.t, 0);
  EXPECT_LE(found.t, 1);
  const Vec3 on_first = first.begin + found.s * (first.end - first.begin);
  const Vec3 on_second = second.begin + found.t * (second.end - second.begin);
  EXPECT_LT((on_first - on_second - found.separation).norm(), 1e-14);
  EXPECT_DOUBLE_EQ(found.distance, found.separation.norm());
}

TEST(ClosestPoints, OfRandomSegmentsAreTheScannedMinimum) {
  for (std::uint32_t trial = 0; trial < 500; ++trial) {
    const Segment first = {random_point(0, trial), random_point(1, trial)};
    const Segment second = {random_point(2, trial), random_point(3, trial)};
    const ClosestPoints found = closest_points(first, second);
    expect_consistent(first, second, found);
    const double scanned = scanned_distance(first, second, 400);
    EXPECT_LE(found.distance, scanned + 1e-12);
    // |d/ds distance| <= length, and the nearest scanned point is within half a spacing.
    EXPECT_GE(found.distance, scanned - (first.end - first.begin).norm() / 800);
  }
}

TEST(ClosestPoints, OfNearlyParallelSegmentsAreTheScannedMinimum) {
  for (const double angle : {1e-1, 1e-3, 1e-5, 1e-6, 1e-7, 1e-9, 0.0}) {
    for (std::uint32_t trial = 0; trial < 50; ++trial) {
      const Segment first = {random_point(0, trial), random_point(1, trial)};
      const Vec3 along = first.end - first.begin;
      const Vec3 shift = random_point(2, trial);
      const Vec3 turn = angle * random_point(3, trial);
      const Segment second = {first.begin + shift,
                              first.begin + shift + (trial % 2 ? 1.0 : -1.0) * along + turn};
      const ClosestPoints found = closest_points(first, second);
      expect_consistent(first, second, found);
      // Below an angle of 1e-6 the middle of the overlap is taken: at most half an overlap times 1e-6 too
      // far.
      EXPECT_LE(found.distance, scanned_distance(first, second, 400) + 0.5e-6 * along.norm());
    }
  }
}

TEST(ClosestPoints, OfParallelOverlapIsItsMiddle) {
  const ClosestPoints found = closest_points({{0, 0, 0}, {2, 0, 0}}, {{1, 1, 0}, {3, 1, 0}});
  EXPECT_DOUBLE_EQ(found.s, 0.75);
  EXPECT_DOUBLE_EQ(found.t, 0.25);
  EXPECT_DOUBLE_EQ(found.distance, 1);
  EXPECT_TRUE(found.separation.isApprox(Vec3(0, -1, 0)));
}

TEST(ClosestPoints, EndToEndAreTheEnds) {
  const ClosestPoints found = closest_points({{0, 0, 0}, {1, 0, 0}}, {{1.5, 0, 0}, {3, 0, 0}});
  EXPECT_DOUBLE_EQ(found.s, 1);
  EXPECT_DOUBLE_EQ(found.t, 0);
  EXPECT_DOUBLE_EQ(found.distance, 0.5);
}

TEST(ClosestPoints, CrossingSegmentsTouchInside) {
  const ClosestPoints found = closest_points({{-1, 0, 0}, {1, 0, 0}}, {{0, -1, 0}, {0, 3, 0}});
  EXPECT_DOUBLE_EQ(found.s, 0.5);
  EXPECT_DOUBLE_EQ(found.t, 0.25);
  EXPECT_DOUBLE_EQ(found.distance, 0);
}

TEST(ClosestPoints, OfPointsAreThePoints) {
  EXPECT_DOUBLE_EQ(closest_points({{0, 0, 0}, {0, 0, 0}}, {{3, 4, 0}, {3, 4, 0}}).distance, 5);
  EXPECT_DOUBLE_EQ(closest_points({{0, 0, 0}, {0, 0, 0}}, {{-1, 4, 0}, {1, 4, 0}}).distance, 4);
  EXPECT_DOUBLE_EQ(closest_points({{-1, 4, 0}, {1, 4, 0}}, {{0, 0, 0}, {0, 0, 0}}).distance, 4);
}

}  // namespace
}  // namespace fiberfate
