// Tests the rates of a Couette rheometer.
#include "continuum/couette_rheometer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace fiberfate {
namespace {

TEST(CouetteRheometerTest, AllRatesAgreeInANarrowGap) {
  for (const CouetteRate choice : {CouetteRate::inner_wall, CouetteRate::outer_wall, CouetteRate::mean})
    EXPECT_NEAR(shear_rate({1, 1.0001, 0.4, choice}, 60) / shear_rate({1, 1.0001}, 60), 1, 1e-3);
}

TEST(CouetteRheometerTest, NewtonianRatesAreTheTextbooks) {
  // rate(r) = 2 omega R_i^2 R_o^2/((R_o^2 - R_i^2) r^2)
  const double omega = 2 * M_PI * 30 / 60;
  const double inner = 0.02, outer = 0.03;
  const double at_inner = 2 * omega * outer * outer / (outer * outer - inner * inner);
  EXPECT_NEAR(shear_rate({inner, outer, 1, CouetteRate::inner_wall}, 30), at_inner, 1e-12);
  EXPECT_NEAR(shear_rate({inner, outer, 1, CouetteRate::outer_wall}, 30),
              at_inner * inner * inner / (outer * outer), 1e-12);
  const double mean =
      at_inner * inner * inner * 2 * std::log(outer / inner) / (outer * outer - inner * inner);
  EXPECT_NEAR(shear_rate({inner, outer, 1, CouetteRate::mean}, 30), mean, 1e-12);
}

TEST(CouetteRheometerTest, MeanIsTheIntegralForAPowerLaw) {
  const CouetteRheometer rheometer = {0.02, 0.03, 0.4, CouetteRate::mean};
  const double at_inner = shear_rate({0.02, 0.03, 0.4, CouetteRate::inner_wall}, 30);
  double integral = 0;
  constexpr int rings = 20000;
  for (int i = 0; i < rings; ++i) {
    const double r = 0.02 + 0.01 * (i + 0.5) / rings;
    integral += at_inner * std::pow(0.02 / r, 5) * r * 0.01 / rings;
  }
  EXPECT_NEAR(shear_rate(rheometer, 30) / (2 * integral / (0.0009 - 0.0004)), 1, 1e-8);
  EXPECT_GT(at_inner, shear_rate(rheometer, 30));
}

TEST(CouetteRheometerTest, RefusesAGapThatIsNone) {
  EXPECT_THROW((void)shear_rate({0.03, 0.03}, 30), InputError);
  EXPECT_THROW((void)shear_rate({0, 0.03}, 30), InputError);
  EXPECT_THROW((void)shear_rate({0.02, 0.03, 0}, 30), InputError);
}

}  // namespace
}  // namespace fiberfate
