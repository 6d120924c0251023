// Tests lattices that reproduce themselves: exact shapes, bounds that hold for ever, remaps that nothing
// notices.
#include "fibers/lattice_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fibers/cell.hpp"

namespace fiberfate {
namespace {

const Vec3 cube(1, 1, 1);
const Mat3 planar = Vec3(1, -1, 0).asDiagonal();
const Mat3 uniaxial = Vec3(1, -0.5, -0.5).asDiagonal();

Mat3 mixed(double alpha) {
  Mat3 gradient = Mat3::Zero();
  gradient(0, 1) = 1;
  gradient(1, 0) = alpha;
  return gradient;
}

/// Shortest image while a cell flows on in steps.
struct Course {
  double nearest = 1e300;
  double volume_error = 0;
};
Course follow(Cell cell, const Mat3& gradient, double duration, double step) {
  const double volume = cell.volume();
  Course course;
  for (double time = 0; time < duration; time += step) {
    deform(cell, gradient, step);
    if (is_skewed(cell)) reduce(cell);
    course.nearest = std::min(course.nearest, nearest_image(cell));
    course.volume_error = std::max(course.volume_error, std::abs(cell.volume() / volume - 1));
  }
  return course;
}

TEST(PlanarLattice, IsTheTurnedSquareOfKraynikAndReinelt) {
  const Mat3 first = stretched_frame(LatticeKind::planar, Mat3::Identity(), cube).lattice();
  Mat3 expected = Mat3::Identity();
  expected.topLeftCorner<2, 2>() << 0.850650808352, 0.525731112119, -0.525731112119, 0.850650808352;
  EXPECT_LT((first - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(PlanarLattice, IsItselfAfterItsPeriod) {
  const double period = std::log((3 + std::sqrt(5.0)) / 2);
  LatticeFrame frame = stretched_frame(LatticeKind::planar, Mat3::Identity(), cube);
  const Mat3 first = frame.lattice();
  for (int i = 0; i < 1000; ++i) frame.flow(planar, period / 1000);
  const Mat3 whole = first.inverse() * frame.lattice();
  EXPECT_LT((whole - whole.array().round().matrix()).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(frame.strain.norm(), 1e-12);
}

TEST(PlanarLattice, KeepsImagesApartForEver) {
  const Cell cell = cell_of(stretched_frame(LatticeKind::planar, Mat3::Identity(), cube));
  const Course course = follow(cell, planar, 50, 1e-3);
  EXPECT_NEAR(course.nearest, std::pow(0.8, 0.25), 1e-6);
  EXPECT_LT(course.volume_error, 1e-14);
}

TEST(SpatialLattice, HasTheShapeOfDobson) {
  const Mat3 first = stretched_frame(LatticeKind::spatial, Mat3::Identity(), cube).lattice();
  Mat3 expected;
  expected << 0.327985277606, 0.591009048506, 0.736976229100,  //
      0.736976229100, 0.327985277606, -0.591009048506,         //
      -0.591009048506, 0.736976229100, -0.327985277606;
  for (int i = 0; i < 3; ++i) {
    const double sign = first.row(i).dot(expected.row(i)) > 0 ? 1 : -1;  // rows are eigenvectors
    EXPECT_LT((sign * first.row(i) - expected.row(i)).cwiseAbs().maxCoeff(), 1e-12) << first;
  }
}

TEST(SpatialLattice, KeepsImagesApartForEver) {
  const Cell cell = cell_of(stretched_frame(LatticeKind::spatial, Mat3::Identity(), cube));
  for (const auto& [gradient, bound] :
       {std::pair{uniaxial, 0.905444}, {Mat3(-2 * uniaxial), 0.905444}, {planar, 0.905595}}) {
    const Course course = follow(cell, gradient, 60, 2e-3);
    EXPECT_NEAR(course.nearest, bound, 1e-5) << gradient.diagonal().transpose();
    EXPECT_LT(course.volume_error, 1e-14);
  }
}

TEST(SpatialLattice, FollowsAHistoryOfElongations) {
  Cell cell = cell_of(stretched_frame(LatticeKind::spatial, Mat3::Identity(), cube));
  const Mat3 first = cell.lattice;
  for (const Mat3& gradient : {planar, uniaxial, Mat3(-uniaxial), Mat3(-planar)}) {
    for (int i = 0; i < 500; ++i) {
      deform(cell, gradient, 0.01);
      if (is_skewed(cell)) reduce(cell);
    }
  }
  const Mat3 whole = first.inverse() * cell.lattice;
  EXPECT_LT((whole - whole.array().round().matrix()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(LongCell, IsBoundedToo) {
  const Cell cell = cell_of(stretched_frame(LatticeKind::spatial, Mat3::Identity(), Vec3(4, 1, 1)));
  EXPECT_NEAR(cell.volume(), 4, 1e-14);
  EXPECT_GT(follow(cell, uniaxial, 30, 1e-2).nearest, 0.9 * std::cbrt(4.0));
}

TEST(SlantedAxes, KeepTheVolumeAndTheImagesApart) {
  for (const auto& [rate, bound] : {std::pair{0.3, 0.497737}, {0.05, 0.211211}}) {
    Mat3 gradient = Mat3::Zero();
    gradient(0, 0) = rate;
    gradient(1, 1) = -rate;
    gradient(0, 1) = 1;
    Mat3 axes = Mat3::Identity();
    axes.col(1) = Vec3(1, -2 * rate, 0).normalized();
    axes.col(1) *= axes.determinant() < 0 ? -1 : 1;
    const LatticeFrame frame = stretched_frame(LatticeKind::planar, axes, cube);
    ASSERT_TRUE(frame.follows(gradient));
    EXPECT_FALSE(frame.follows(mixed(0.5)));
    const Cell cell = cell_of(frame);
    EXPECT_NEAR(cell.volume(), 1, 1e-13);
    EXPECT_NEAR(follow(cell, gradient, 20 / rate, 1e-3 / rate).nearest, bound, 1e-5);
  }
}

TEST(RotatingLattice, TurnsWithoutEnd) {
  for (const auto& [alpha, bound] : {std::pair{-0.5, 0.8409}, {-0.05, 0.4729}}) {
    const double root = std::sqrt(-alpha);
    const Mat3 axes = Vec3(1 / std::sqrt(root), std::sqrt(root), 1).asDiagonal();
    const LatticeFrame frame = stretched_frame(LatticeKind::rotating, axes, cube);
    ASSERT_TRUE(frame.follows(mixed(alpha)));
    Cell cell = cell_of(frame);
    EXPECT_NEAR(follow(cell, mixed(alpha), 100, 1e-3).nearest, bound, 1e-4);
    const Mat3 first = frame.lattice();
    for (int i = 0; i < 100; ++i) deform(cell, mixed(alpha), 2 * 3.14159265358979323846 / root / 4 / 100);
    const Mat3 whole = first.inverse() * cell.lattice;
    EXPECT_LT((whole - whole.array().round().matrix()).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(CellOfAFrame, CarriesPointsOfItsLatticeWithTheFluid) {
  for (const Mat3& gradient : {planar, uniaxial}) {
    Cell cell = cell_of(stretched_frame(LatticeKind::spatial, Mat3::Identity(), cube));
    const Vec3 before = cell.shift(IntVec3(2, -1, 1));
    deform(cell, gradient, 0.8);
    EXPECT_LT((cell.shift(IntVec3(2, -1, 1)) - flow_map(gradient, 0.8) * before).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace fiberfate
