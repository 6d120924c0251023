// Tests the flowing cell: deformation, reduction of its basis, images.
#include "fibers/cell.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"

namespace fiberfate {
namespace {

Mat3 shear(double rate) {
  Mat3 gradient = Mat3::Zero();
  gradient(0, 1) = rate;
  return gradient;
}

TEST(Cell, KnowsItsVolumeHeightsAndShifts) {
  Cell cell = rectangular_cell(Vec3(1, 2, 3));
  cell.lattice(0, 1) = 0.5;  // sheared: the heights across y and z stay
  EXPECT_DOUBLE_EQ(cell.volume(), 6);
  EXPECT_NEAR(cell.height(1), 2, 1e-14);
  EXPECT_LT(cell.height(0), 1);
  EXPECT_TRUE(cell.shift(IntVec3(1, 1, -1)).isApprox(Vec3(1.5, 2, -3)));
}

TEST(Deform, OfSimpleShearTiltsExactly) {
  Cell cell = rectangular_cell(Vec3(1, 2, 3));
  deform(cell, shear(4.0), 0.125);
  EXPECT_EQ(cell.lattice(0, 1), 1.0);
  EXPECT_EQ(cell.lattice.col(0), Vec3(1, 0, 0));
  EXPECT_EQ(cell.volume(), 6.0);
}

TEST(Deform, OfExtensionFollowsTheExponential) {
  Cell cell = rectangular_cell(Vec3(1, 1, 1));
  Mat3 gradient = Mat3::Zero();
  gradient.diagonal() = Vec3(1, -0.5, -0.5);
  deform(cell, gradient, 0.7);
  EXPECT_NEAR(cell.lattice(0, 0), std::exp(0.7), 1e-13);
  EXPECT_NEAR(cell.volume(), 1, 1e-13);
}

TEST(Deform, KeepsWalledDirections) {
  Cell cell = rectangular_cell(Vec3(1, 1, 1));
  cell.boundary[1] = Boundary::walls;
  deform(cell, shear(2.0), 1.0);
  EXPECT_EQ(cell.lattice, Mat3(Mat3::Identity()));
}

TEST(Reduce, OfSimpleShearIsTheLeesEdwardsReset) {
  Cell cell = rectangular_cell(Vec3(1, 1, 1));
  cell.lattice(0, 1) = 0.5;
  EXPECT_FALSE(is_skewed(cell)) << "half a cell is not too much";
  cell.lattice(0, 1) = 1.7;
  ASSERT_TRUE(is_skewed(cell));
  const Mat3 old = cell.lattice;
  const Eigen::Matrix3i change = reduce(cell);
  EXPECT_NEAR(cell.lattice(0, 1), -0.3, 1e-14);
  EXPECT_TRUE(cell.lattice.isApprox(old * change.cast<double>(), 1e-14));
  EXPECT_EQ(std::abs(change.cast<double>().determinant()), 1.0);
  EXPECT_FALSE(is_skewed(cell));
}

TEST(ImageOf, CountsCellsAndIgnoresWalls) {
  Cell cell = rectangular_cell(Vec3(1, 1, 1));
  cell.lattice(0, 1) = 0.4;
  EXPECT_EQ(image_of(cell, Vec3(0.5, 1.5, -0.1)), IntVec3(-1, 1, -1));
  cell.boundary[1] = Boundary::walls;
  EXPECT_EQ(image_of(cell, Vec3(0.9, 1.5, 0.5))[1], 0);
}

}  // namespace
}  // namespace fiberfate
