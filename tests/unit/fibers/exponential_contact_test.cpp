// Tests the published normal force.
#include <gtest/gtest.h>

#include <cmath>

#include "fibers/contact_laws/contact_registry.hpp"

namespace fiberfate {
namespace {

constexpr double radius = 9.5e-6;
constexpr ContactPair pair{{radius, 73e9}, {radius, 73e9}};

/// The law that the thesis' program computes, without the ramp: A D exp(−B (d/a − 2)) for d < d_cut.
double published_force(const ContactParameters& contact, double distance) {
  if (distance >= contact.cutoff * radius) return 0;
  return contact.force_constant * 2 * radius * std::exp(-contact.decay * (distance / radius - 2));
}

TEST(ExponentialContact, IsThePublishedLawBelowTheRamp) {
  ContactParameters contact;
  for (const double cutoff : {2.0, 2.5}) {
    contact.cutoff = cutoff;
    const NormalForce force(contact, pair);
    for (const double overlap : {0.15, 0.5, 1.0, 1.3, 1.9}) {
      const double distance = (cutoff - overlap) * radius;
      EXPECT_DOUBLE_EQ(force(distance), published_force(contact, distance)) << overlap;
    }
    EXPECT_EQ(force(cutoff * radius + 0.5 * contact.ramp * 1.001), 0);
    EXPECT_EQ(force(1.0), 0);
  }
}

TEST(ExponentialContact, IsHalfItsStepAtTheCutoff) {
  const ContactParameters contact;
  const double step = contact.force_constant * 2 * radius;
  EXPECT_NEAR(NormalForce(contact, pair)(2 * radius), step / 2, 1e-12 * step);
}

// Continuous, never rising with distance, never steeper than the bound that the implicit step relies on.
TEST(ExponentialContact, IsBoundedByItsStiffness) {
  const ContactParameters contact;
  const NormalForce force(contact, pair);
  const double spacing = 1e-3 * contact.ramp;
  for (double d = 1.5 * radius; d < force.hold(); d += spacing) {
    const double fall = force(d) - force(d + spacing);
    EXPECT_GE(fall, 0);
    EXPECT_LE(fall, force.stiffness({d, 1}, force(d)) * spacing * (1 + 1e-9)) << d / radius;
  }
}

TEST(ExponentialContact, EndsAtItsReach) {
  const ContactParameters contact;
  const NormalForce force(contact, pair);
  EXPECT_LT(force(force.reach()), 1e-12 * force(0));
  EXPECT_EQ(force(force.reach() + 1e-3 * contact.ramp), 0);
  EXPECT_GT(force(force.reach() - 1e-3 * contact.ramp), 0);
}

TEST(ExponentialContact, IsSwitchedOffByItsConstant) {
  ContactParameters contact;
  contact.force_constant = 0;
  const NormalForce force(contact, pair);
  EXPECT_EQ(force.reach(), 0);
  EXPECT_EQ(force.hold(), 0);
  EXPECT_EQ(force(radius), 0);
}

}  // namespace
}  // namespace fiberfate
