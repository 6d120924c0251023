// Tests the stiffness of a hinge.
#include "dynamics/bending.hpp"

#include <gtest/gtest.h>

#include "base/constants.hpp"

namespace fiberfate {
namespace {

Vec3 turn_by(double angle) {
  return Vec3(std::cos(angle), std::sin(angle), 0) - Vec3::UnitX();
}

// stiffness · |b| · cos(theta/2) is the moment, because b = p_after − p_before makes the angle theta/2 with
// both normals: the couple of the node forces on a rod is stiffness |p × b| = stiffness sin(theta) = E I
// theta / l̄.
TEST(ElasticHinge, CarriesTheMomentOfABeam) {
  const ElasticHinge hinge{.bending_stiffness = 4.7e-10};
  for (const double angle : {1e-12, 1e-6, 0.01, 0.5, 1.5, 2.5, 3.0}) {
    const double moment = hinge(turn_by(angle), 1e-4) * std::sin(angle);
    EXPECT_NEAR(moment, 4.7e-10 * angle / 1e-4, 1e-10 * moment) << angle;
  }
}

TEST(ElasticHinge, IsFiniteWhenStraightAndWhenFolded) {
  const ElasticHinge hinge{.bending_stiffness = 1};
  EXPECT_DOUBLE_EQ(hinge(Vec3::Zero(), 1), 1);
  EXPECT_TRUE(std::isfinite(hinge(Vec3(-2, 0, 0), 1)));
}

}  // namespace
}  // namespace fiberfate
