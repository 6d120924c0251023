// Checks the fits of the rheometer on stresses that are made up by their laws.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "continuum/anisotropic_stress.hpp"
#include "studies/rheometer/stress_fit.hpp"

namespace fiberfate {
namespace {

/// A4 of fibers in one direction.
Mat6 aligned(const Vec3& along) {
  const Vec6 pairs = to_components(along.normalized() * along.normalized().transpose());
  return pairs * pairs.transpose();
}

/// What fibers of a particle number in two directions make of a shear.
StressReading made_up(double number, double share_along, double rate) {
  StressReading one;
  one.viscosity = 200;
  one.volume_fraction = 0.05;
  one.strain_rate(0, 1) = one.strain_rate(1, 0) = rate / 2;
  one.fourth = share_along * aligned({1, 1, 0}) + (1 - share_along) * aligned({1, 0.1, 0.3});
  const Mat3& strain = one.strain_rate;
  one.stress = 2 * one.viscosity * one.volume_fraction * number * contracted(one.fourth, strain);
  one.relative_viscosity = 1 + double_dot(one.stress, strain) / (2 * one.viscosity * strain.squaredNorm());
  return one;
}

std::vector<StressReading> many(double number) {
  std::vector<StressReading> all;
  for (const double rate : {1.0, 10.0, 100.0})
    for (const double share : {0.1, 0.3, 0.7}) all.push_back(made_up(number, share, rate));
  return all;
}

// Made up by the laws themselves, both numbers come back to round-off, whatever the rates.
TEST(StressFit, FindsTheNumbersOfExactStresses) {
  const std::vector<StressReading> readings = many(40);
  const ParticleNumberFit stress = fit_particle_number(readings);
  EXPECT_NEAR(stress.particle_number.value, 40, 1e-11);
  EXPECT_NEAR(stress.particle_number.error, 0, 1e-11);
  EXPECT_NEAR(stress.explained, 1, 1e-13);
  const TroutonFit viscosity = fit_trouton_term(readings);
  EXPECT_NEAR(viscosity.viscosity_ratio.value, 1, 1e-12);
  EXPECT_NEAR(viscosity.trouton_term.value, 0.05 * 40, 1e-11);
  EXPECT_TRUE(viscosity.is_told());
  EXPECT_EQ(viscosity.readings, readings.size());
}

// The pressure is nobody's: an isotropic stress on top changes nothing.
TEST(StressFit, IgnoresIsotropicStress) {
  std::vector<StressReading> readings = many(40);
  for (StressReading& one : readings) one.stress += 1e4 * Mat3::Identity();
  EXPECT_NEAR(fit_particle_number(readings).particle_number.value, 40, 1e-9);
}

// Slow and fast readings count alike: of two that differ, the fit is the mean where x is the same.
TEST(StressFit, CountsAllRatesAlike) {
  const std::vector<StressReading> readings = {made_up(30, 0.5, 1), made_up(50, 0.5, 1000)};
  const ParticleNumberFit fit = fit_particle_number(readings);
  EXPECT_NEAR(fit.particle_number.value, 40, 1e-11);
  EXPECT_NEAR(fit.particle_number.error, 10, 1e-11);  // standard error of the mean of 30 and 50
}

// With scatter of a known size, the intervals of 95 % hold the truth in 95 % of many repetitions.
TEST(StressFit, HasIntervalsThatHoldTheTruth) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0, 0.02);
  int number_held = 0, term_held = 0, ratio_held = 0;
  constexpr int repetitions = 2000;
  for (int i = 0; i < repetitions; ++i) {
    std::vector<StressReading> readings = many(40);
    for (StressReading& one : readings) {
      one.stress *= 1 + normal(random);
      one.relative_viscosity += normal(random);
    }
    const auto holds = [](const FittedNumber& fitted, double truth) {
      return fitted.lower <= truth && truth <= fitted.upper;
    };
    const TroutonFit viscosity = fit_trouton_term(readings);
    number_held += holds(fit_particle_number(readings).particle_number, 40) ? 1 : 0;
    term_held += holds(viscosity.trouton_term, 2) ? 1 : 0;
    ratio_held += holds(viscosity.viscosity_ratio, 1) ? 1 : 0;
  }
  // 0.95 within 5 standard deviations of 2000 repetitions, 0.024. The nine readings of N_p weigh unequally,
  // so that its interval is not exact.
  EXPECT_NEAR(term_held / static_cast<double>(repetitions), 0.95, 0.024);
  EXPECT_NEAR(ratio_held / static_cast<double>(repetitions), 0.95, 0.024);
  EXPECT_NEAR(number_held / static_cast<double>(repetitions), 0.95, 0.04);
}

// Where x hardly varies, scatter hides R_T, and the fit says so.
TEST(StressFit, TellsNothingOfRTWhereAllFibersLieAlike) {
  std::vector<StressReading> readings;
  for (int i = 0; i < 6; ++i) {
    readings.push_back(made_up(40, 0.5 + 0.001 * i, 10));
    readings.back().relative_viscosity += i % 2 == 0 ? 0.02 : -0.02;
  }
  EXPECT_FALSE(fit_trouton_term(readings).is_told());
  EXPECT_LT(fit_trouton_term(readings).largest_share, 1.01 * fit_trouton_term(readings).least_share);
}

TEST(StressFit, NeedsReadings) {
  EXPECT_TRUE(std::isnan(fit_particle_number({}).particle_number.value));
  EXPECT_FALSE(fit_trouton_term({}).is_told());
  const std::vector<StressReading> one = {made_up(40, 0.5, 10)};
  EXPECT_NEAR(fit_particle_number(one).particle_number.value, 40, 1e-11);
  EXPECT_TRUE(std::isnan(fit_particle_number(one).particle_number.error));
  EXPECT_TRUE(std::isnan(fit_trouton_term(one).trouton_term.value));
  std::vector<StressReading> with_gap = many(40);
  with_gap.front().stress(0, 0) = std::nan("");
  EXPECT_NEAR(fit_particle_number(with_gap).particle_number.value, 40, 1e-11);
  EXPECT_EQ(fit_trouton_term(with_gap).readings, with_gap.size() - 1);
}

}  // namespace
}  // namespace fiberfate
