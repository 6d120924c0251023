// Tests the stiffness of a hinge.
#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/hinge_laws/hinge_registry.hpp"

namespace fiberfate {
namespace {

double squared_half_sine(double angle) {
  return std::sin(angle / 2) * std::sin(angle / 2);
}

// The couple of the node forces on a rod is stiffness |p × b| = (E I / l̄) ratio sin(theta), with b = p_after
// − p_before; a beam bent by theta over l̄ carries E I theta / l̄.
TEST(ElasticHinge, CarriesTheMomentOfABeam) {
  const Hinge hinge("elastic");
  for (const double angle : {1e-12, 1e-6, 0.01, 0.5, 1.5, 2.5, 3.0}) {
    const double moment = hinge(squared_half_sine(angle)) * std::sin(angle);
    EXPECT_NEAR(moment, angle, 1e-10 * angle) << angle;
  }
}

TEST(ElasticHinge, IsFiniteWhenStraightAndWhenFolded) {
  const Hinge hinge("elastic");
  EXPECT_DOUBLE_EQ(hinge(0), 1);
  EXPECT_TRUE(std::isfinite(hinge(1)));
}

}  // namespace
}  // namespace fiberfate
