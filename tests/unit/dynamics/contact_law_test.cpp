// Tests the normal force and friction of a contact.
#include "dynamics/contact_law.hpp"

#include <gtest/gtest.h>

namespace fiberfate {
namespace {

constexpr double radius = 9.5e-6;

/// The law that the thesis' program computes, without the ramp: A D exp(−B (d/a − 2)) for d < d_cut.
double published_force(const ContactParameters& contact, double distance) {
  if (distance >= contact.cutoff * radius) return 0;
  return contact.force_constant * 2 * radius * std::exp(-contact.decay * (distance / radius - 2));
}

TEST(NormalForce, IsThePublishedLawBelowTheRamp) {
  ContactParameters contact;
  for (const double cutoff : {2.0, 2.5}) {
    contact.cutoff = cutoff;
    const NormalForce force(contact, radius);
    for (const double overlap : {0.15, 0.5, 1.0, 1.3, 1.9}) {
      const double distance = (cutoff - overlap) * radius;
      EXPECT_DOUBLE_EQ(force(distance), published_force(contact, distance)) << overlap;
    }
    EXPECT_EQ(force(cutoff * radius + 0.5 * contact.ramp * 1.001), 0);
    EXPECT_EQ(force(1.0), 0);
  }
}

TEST(NormalForce, IsHalfItsStepAtTheCutoff) {
  const ContactParameters contact;
  const double step = contact.force_constant * 2 * radius;
  EXPECT_NEAR(NormalForce(contact, radius)(2 * radius), step / 2, 1e-12 * step);
}

// Continuous, never rising with distance, never steeper than the bound that the implicit step relies on.
TEST(NormalForce, IsBoundedByItsStiffness) {
  const ContactParameters contact;
  const NormalForce force(contact, radius);
  const double spacing = 1e-3 * contact.ramp;
  for (double d = 1.5 * radius; d < force.reach() + contact.ramp; d += spacing) {
    const double fall = force(d) - force(d + spacing);
    EXPECT_GE(fall, 0);
    EXPECT_LE(fall, force.stiffness(force(d)) * spacing * (1 + 1e-9)) << d / radius;
  }
}

TEST(NormalForce, EndsAtItsReach) {
  const ContactParameters contact;
  const NormalForce force(contact, radius);
  EXPECT_LT(force(force.reach()), 1e-12 * force(0));
  EXPECT_EQ(force(force.reach() + 1e-3 * contact.ramp), 0);
  EXPECT_GT(force(force.reach() - 1e-3 * contact.ramp), 0);
}

TEST(Friction, IsCoulombsWellAboveTheSlipVelocityAndVanishesAtRest) {
  const Friction friction{.coefficient = 0.3, .slip_velocity = 1e-5};
  const double normal = 2e-3;
  const double fast = 1e-1;
  EXPECT_NEAR(friction(normal, fast * fast) * fast, 0.3 * normal, 1e-8 * normal);
  const double slow = 1e-9;
  EXPECT_LT(friction(normal, slow * slow) * slow, 1e-4 * 0.3 * normal);
  EXPECT_EQ(friction(0, 1), 0);
}

}  // namespace
}  // namespace fiberfate
