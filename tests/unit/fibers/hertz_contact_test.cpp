// Tests the elastic contact of crossed cylinders against Hertz' theory.
#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"
#include "fibers/contact_laws/contact_registry.hpp"

namespace fiberfate {
namespace {

constexpr double radius = 9.5e-6;
constexpr ContactPair glass{{radius, 73e9}, {radius, 73e9}};

ContactParameters hertz() {
  ContactParameters contact;
  contact.law = "hertz";
  contact.poisson_ratio = 0.22;
  return contact;
}

/// E* = E/(2 (1 − nu²)) of two like bodies, Pa.
const double modulus = 73e9 / (2 * (1 - 0.22 * 0.22));

double force_at(double overlap, double sine) {
  return NormalForce(hertz(), glass)({2 * radius - overlap, sine});
}

/// Hertz' solution for two cylinders of radius R that cross, by the ratio k = b/a of the semi-axes of their
/// patch. With e² = 1 − k² and complete elliptic integrals K, E of modulus e, curvatures A = (1 − cos
/// alpha)/2R and B = (1 + cos alpha)/2R obey B/A = (E/k² − K)/(K − E), the largest pressure is p = E* A e²
/// a/(k (K − E)), the approach p b K/E* and the force (2/3) p pi a b (Johnson 1985, (4.26) to (4.30)).
struct HertzPatch {
  double sine, overlap, force;
};
HertzPatch theory_of_patch(double k, double longer) {
  const double e2 = 1 - k * k;
  const double e = std::sqrt(e2);
  const double first = std::comp_ellint_1(e), second = std::comp_ellint_2(e);
  const double ratio = (second / (k * k) - first) / (first - second);
  const double angle = 2 * std::atan(1 / std::sqrt(ratio));
  const double curvature = (1 - std::cos(angle)) / (2 * radius);
  const double pressure = modulus * curvature * e2 * longer / (k * (first - second));
  return {std::sin(angle), pressure * k * longer * first / modulus,
          2.0 / 3 * pressure * pi * longer * k * longer};
}

// A sphere of the same radius on a plane, and crossed cylinders at right angles, are one problem: F = (4/3)
// E* sqrt(R) delta^(3/2). Glass of 19 um sinks in by 0.12 um under 6.7 mN.
TEST(HertzContact, IsASphereOnAPlaneAtRightAngles) {
  for (const double overlap : {1e-9, 1.2e-7, 1e-6}) {
    const double theory = 4.0 / 3 * modulus * std::sqrt(radius) * std::pow(overlap, 1.5);
    EXPECT_NEAR(force_at(overlap, 1), theory, 1e-7 * theory) << overlap;  // round-off of 2R − overlap
  }
  EXPECT_NEAR(force_at(1.2e-7, 1), 6.6e-3, 0.1e-3);
}

TEST(HertzContact, GrowsWithThePowerThreeHalves) {
  for (const double sine : {1.0, 0.5, 0.01})
    EXPECT_NEAR(force_at(4e-7, sine) / force_at(1e-7, sine), 8, 1e-6);
}

// The power of the sine stands for elliptic integrals; the worst of it, at about 17 degrees, is 5.0 %.
TEST(HertzContact, FollowsHertzAtAnyAngleDownToFiveDegrees) {
  for (const double k : {0.999, 0.8, 0.6, 0.4, 0.3, 0.2, 0.15, 0.1, 0.07, 0.05, 0.03}) {
    const HertzPatch patch = theory_of_patch(k, 0.02 * radius / k);
    ASSERT_GT(patch.sine, 0.1);
    EXPECT_NEAR(force_at(patch.overlap, patch.sine), patch.force, 0.0505 * patch.force) << patch.sine;
  }
}

// Below that a point force cannot know the length of the patch: it stays as it is, and bounded.
TEST(HertzContact, IsSteadyTowardsParallelRods) {
  EXPECT_EQ(force_at(1e-7, 0), force_at(1e-7, 0.1));
  EXPECT_EQ(force_at(1e-7, 1e-9), force_at(1e-7, 0.05));
}

TEST(HertzContact, TakesTheComplianceOfBothFibers) {
  const ContactPair rigid{{radius, 73e9}, {radius, 73e15}};
  const NormalForce like(hertz(), glass), on_rigid(hertz(), rigid);
  EXPECT_NEAR(on_rigid(1.99 * radius) / like(1.99 * radius), 2, 1e-5);
}

TEST(HertzContact, IsBoundedByItsStiffness) {
  const NormalForce force(hertz(), glass);
  const double spacing = 1e-3 * radius;
  for (const double sine : {1.0, 0.3, 0.0}) {
    for (double d = 1.5 * radius; d < 2.05 * radius; d += spacing) {
      const ContactGap<double> gap{d, sine}, wider{d + spacing, sine};
      const double fall = force(gap) - force(wider);
      EXPECT_GE(fall, 0);
      EXPECT_LE(fall, force.stiffness(wider, force(wider)) * spacing) << d / radius;
    }
  }
  EXPECT_EQ(force(force.reach()), 0);
  EXPECT_GT(force.stiffness({0.999 * force.hold(), 1}, 0), 0);
  EXPECT_EQ(force.stiffness({force.hold(), 1}, 0), 0);
}

}  // namespace
}  // namespace fiberfate
