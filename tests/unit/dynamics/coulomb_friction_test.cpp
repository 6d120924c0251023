// Tests Coulomb friction.
#include <gtest/gtest.h>

#include "dynamics/friction_laws/friction_registry.hpp"

namespace fiberfate {
namespace {

TEST(CoulombFriction, IsCoulombsWellAboveTheSlipVelocityAndVanishesAtRest) {
  const Friction friction({.slip_velocity = 1e-5}, 0.3);
  const double normal = 2e-3;
  const double fast = 1e-1;
  EXPECT_NEAR(friction(normal, fast * fast) * fast, 0.3 * normal, 1e-8 * normal);
  const double slow = 1e-9;
  EXPECT_LT(friction(normal, slow * slow) * slow, 1e-4 * 0.3 * normal);
  EXPECT_EQ(friction(0, 1), 0);
}

}  // namespace
}  // namespace fiberfate
