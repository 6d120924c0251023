// Tests which lattice a flow gets, and which flows get none.
#include "fibers/lattice_choice.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/error.hpp"

namespace fiberfate {
namespace {

const Vec3 cube(1, 1, 1);

Mat3 rows(std::array<double, 9> numbers) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
}

FlowHistory steps(const std::vector<Mat3>& gradients) {
  std::vector<FlowRow> all;
  for (const Mat3& gradient : gradients) all.push_back({static_cast<double>(all.size()), {gradient, 1}});
  return FlowHistory(std::move(all));
}

LatticeKind kind_for(const std::vector<Mat3>& gradients) {
  const Cell cell = cell_for(steps(gradients), cube);
  EXPECT_NEAR(cell.volume(), 1, 1e-12);
  EXPECT_NO_THROW(require_follows(cell, steps(gradients)));
  return cell.frame.kind;
}

std::string refusal_of(const std::vector<Mat3>& gradients) {
  try {
    (void)cell_for(steps(gradients), cube);
  } catch (const InputError& error) {
    return error.problems().front().complaint;
  }
  return "followed";
}

const Mat3 shear = rows({0, 1, 0, 0, 0, 0, 0, 0, 0});
const Mat3 planar = rows({1, 0, 0, 0, -1, 0, 0, 0, 0});
const Mat3 uniaxial = rows({2, 0, 0, 0, -1, 0, 0, 0, -1});

TEST(CellFor, ShearIsABox) {
  EXPECT_EQ(kind_for({shear, Mat3::Zero(), -3 * shear}), LatticeKind::carried);
  EXPECT_EQ(kind_for({Mat3::Zero()}), LatticeKind::carried);
}

TEST(CellFor, ElongationsStretchALattice) {
  EXPECT_EQ(kind_for({planar}), LatticeKind::planar);
  EXPECT_EQ(kind_for({planar, -0.5 * planar}), LatticeKind::planar);
  EXPECT_EQ(kind_for({uniaxial}), LatticeKind::spatial);
  EXPECT_EQ(kind_for({planar, uniaxial, rows({1, 0, 0, 0, 0, 0, 0, 0, -1})}), LatticeKind::spatial);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_EQ(kind_for({turn * uniaxial * turn.transpose()}), LatticeKind::spatial);
  EXPECT_EQ(kind_for({turn * planar * turn.transpose()}), LatticeKind::planar);
}

TEST(CellFor, MixedFlowsStretchOrTurnALattice) {
  EXPECT_EQ(kind_for({rows({0, 1, 0, 0.3, 0, 0, 0, 0, 0})}), LatticeKind::planar);
  EXPECT_EQ(kind_for({rows({0.3, 1, 0, 0, -0.3, 0, 0, 0, 0})}), LatticeKind::planar);
  EXPECT_EQ(kind_for({rows({1, 0.5, 0.2, 0, 0.5, 0.1, 0, 0, -1.5})}), LatticeKind::spatial);
  const Mat3 turning = rows({0, 1, 0, -0.3, 0, 0, 0, 0, 0});
  EXPECT_EQ(kind_for({turning, -2 * turning}), LatticeKind::rotating);
  EXPECT_EQ(kind_for({rows({0.2, 1, 0, -0.3, -0.2, 0, 0, 0, 0})}), LatticeKind::rotating);
}

TEST(CellFor, TakesTheSizeAlongTheAxesOfAnElongation) {
  const Cell cell = cell_for(steps({rows({1, 0, 0, 0, 0, 0, 0, 0, -1})}), Vec3(1, 2, 3));
  // Nothing moves along y: there the cell keeps its edge, and the images are those of a box.
  bool has_edge = false;
  for (int i = 0; i < 3; ++i)
    has_edge = has_edge || (cell.lattice.col(i).cwiseAbs() - Vec3(0, 2, 0)).norm() < 1e-12;
  EXPECT_TRUE(has_edge) << cell.lattice;
  EXPECT_NEAR(cell.volume(), 6, 1e-12);
}

TEST(CellFor, RefusesWhatNoLatticeFollows) {
  EXPECT_NE(refusal_of({rows({1, 0, 0, 0, 1, 0, 0, 0, 1})}).find("changes the volume"), std::string::npos);
  EXPECT_NE(refusal_of({rows({1, 5, 0, -5, 1, 0, 0, 0, -2})}).find("turns and stretches"), std::string::npos);
  EXPECT_NE(refusal_of({rows({1, 1, 0, 0, 1, 0, 0, 0, -2})}).find("shears along an axis"), std::string::npos);
  EXPECT_NE(refusal_of({shear, planar}).find("different axes"), std::string::npos);
  EXPECT_NE(refusal_of({planar, rows({0, 1, 0, 1, 0, 0, 0, 0, 0})}).find("different axes"),
            std::string::npos);
  EXPECT_NE(refusal_of({rows({0, 0, 1, 0, 0, 0, 0, 0, 0})}).find("flat at"), std::string::npos);
}

TEST(RequireFollows, RefusesACellMadeForAnotherFlow) {
  const Cell box = rectangular_cell(cube), stretched = cell_for(steps({planar}), cube);
  EXPECT_THROW(require_follows(box, steps({planar})), InputError);
  EXPECT_THROW(require_follows(stretched, steps({shear})), InputError);
  EXPECT_THROW(require_follows(stretched, steps({uniaxial})), InputError);
  Cell turned = box;
  turned.lattice = Eigen::AngleAxisd(0.3, Vec3::UnitX()).toRotationMatrix();
  EXPECT_THROW(require_follows(turned, steps({shear})), InputError);
  EXPECT_NO_THROW(require_follows(turned, steps({Mat3::Zero()})));
}

TEST(NearestImageEver, IsTheBoundOfTheLattice) {
  EXPECT_NEAR(nearest_image_ever(cell_for(steps({planar}), cube)), std::pow(0.8, 0.25), 1e-3);
  EXPECT_NEAR(nearest_image_ever(cell_for(steps({uniaxial}), cube)), 0.9054, 1e-3);
  EXPECT_NEAR(nearest_image_ever(cell_for(steps({rows({0.05, 1, 0, 0, -0.05, 0, 0, 0, 0})}), cube)), 0.2112,
              2e-3);
  EXPECT_NEAR(nearest_image_ever(cell_for(steps({rows({0, 1, 0, -0.05, 0, 0, 0, 0, 0})}), cube)), 0.4729,
              1e-3);
}

}  // namespace
}  // namespace fiberfate
