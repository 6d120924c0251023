// Tests the relaxation of lengths and the laws that give its coefficients.
#include "continuum/length_relaxation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "continuum/rate_power.hpp"
#include "continuum/stress_induced.hpp"
#include "continuum/unbreakable_length.hpp"

namespace fiberfate {
namespace {

TEST(RelaxLength, IsTheExponential) {
  const LengthRelaxation relaxation = {0.0279, 1.5e-3};
  for (const double t : {0.0, 1e-9, 0.5, 20.0, 150.0})
    EXPECT_NEAR(relax_length(15e-3, relaxation, t), 1.5e-3 + 13.5e-3 * std::exp(-0.0279 * t), 2e-17);
}

TEST(RelaxLength, IsTheSameInOneStepAndInMany) {
  const LengthRelaxation relaxation = {0.05, 0.75e-3};
  double length = 15e-3;
  for (int i = 0; i < 1000; ++i) length = relax_length(length, relaxation, 0.1);
  EXPECT_NEAR(length, relax_length(15e-3, relaxation, 100), 1e-15);
}

TEST(RelaxLength, NeverRisesAndNeverPassesTheFinalLength) {
  for (const double rate : {1e-12, 1e-3, 1.0, 1e6, 1e300}) {
    for (const double start : {1e-3, 1.0000000000000002e-3, 2e-3, 15e-3}) {
      const double end = relax_length(start, {rate, 1e-3}, 1);
      EXPECT_LE(end, start);
      EXPECT_GE(end, 1e-3);
    }
  }
}

TEST(RelaxLength, LeavesShorterFibersAlone) {
  EXPECT_EQ(relax_length(0.5e-3, {1, 1e-3}, 10), 0.5e-3);
  EXPECT_EQ(relax_length(1e-3, {1, 1e-3}, 10), 1e-3);
  EXPECT_EQ(relax_length(1e-3, {0, HUGE_VAL}, 10), 1e-3);
}

TEST(RelaxationLaws, BreakNothingWithoutFlow) {
  const LengthFlow rest = {0, 300};
  EXPECT_EQ(relax_length(0.02, UnbreakableLength{0.1, 1e-3, 2e9, 19e-6}(rest), 1e9), 0.02);
  EXPECT_EQ(relax_length(0.02, RatePower{0.1, 0.5, 1e-3, 0.8, 2e9, 19e-6}(rest), 1e9), 0.02);
  EXPECT_EQ(relax_length(0.02, StressInduced{2e-6, 1.35, 6e4, 1.1, 2e9, 19e-6}(rest), 1e9), 0.02);
}

TEST(RelaxationLaws, AgreeWhereOneContainsTheOther) {
  const LengthFlow flow = {36.652, 225.77};
  const LengthRelaxation simple = UnbreakableLength{0.0803, 1.4e-3, 2e9, 19e-6}(flow);
  const LengthRelaxation power = RatePower{0.0803, 0.5, 1.4e-3, 1, 2e9, 19e-6}(flow);
  EXPECT_NEAR(power.equilibrium_length / simple.equilibrium_length, 1, 1e-14);
  EXPECT_NEAR(power.rate_constant / simple.rate_constant, 1, 1e-14);
  EXPECT_NEAR(simple.equilibrium_length, 0.0803 * 19e-6 * std::sqrt(2e9 / (36.652 * 225.77)), 1e-18);
}

TEST(RelaxationLaws, GiveTheSameInBatchesOfPointsAndClassesOnAnyThreads) {
  constexpr std::size_t points = 1001, classes = 3;
  std::vector<double> rates(points), viscosities(points), lengths(points * classes);
  for (std::size_t i = 0; i < points; ++i) {
    rates[i] = 3.0 * static_cast<double>(i);
    viscosities[i] = 1000.0 / (1 + static_cast<double>(i));
    for (std::size_t c = 0; c < classes; ++c) lengths[c * points + i] = 1e-3 * static_cast<double>(5 * c + 1);
  }
  const StressInduced formula{2e-4, 1.1, 6e4, 1.1, 2e9, 19e-6};
  const RelaxationLawOf law(formula);
  std::vector<double> advanced = lengths;
  relax_lengths(law, {rates, viscosities}, 3.0, advanced);
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t c = 0; c < classes; ++c)
      EXPECT_EQ(advanced[c * points + i],
                relax_length(lengths[c * points + i], formula({rates[i], viscosities[i]}), 3.0));
  const int threads = thread_count();
  use_threads(1);
  relax_lengths(law, {rates, viscosities}, 3.0, lengths);
  use_threads(threads);
  EXPECT_EQ(lengths, advanced);
}

TEST(StressInducedLaw, PassesThroughBothRuns) {
  const std::array<SteadyAttrition, 2> runs = {{{10, 300, {0.02, 2e-3}}, {40, 200, {0.07, 0.9e-3}}}};
  const StressInduced law = solve_stress_induced(runs, 2e9, 17e-6);
  for (const SteadyAttrition& run : runs) {
    const LengthRelaxation found = law({run.rate, run.viscosity});
    EXPECT_NEAR(found.rate_constant / run.relaxation.rate_constant, 1, 1e-13);
    EXPECT_NEAR(found.equilibrium_length / run.relaxation.equilibrium_length, 1, 1e-13);
  }
}

TEST(StressInducedLaw, RefusesRunsThatDoNotDetermineIt) {
  const SteadyAttrition run = {10, 300, {0.02, 2e-3}};
  const SteadyAttrition same_stress = {20, 150, {0.07, 0.9e-3}};
  EXPECT_THROW((void)solve_stress_induced({run, same_stress}, 2e9, 17e-6), InputError);
  EXPECT_THROW((void)rate_exponent({run, run}), InputError);
  EXPECT_THROW((void)interaction_coefficient({0, 300, {0.02, 2e-3}}, 0.5, 2e9, 17e-6), InputError);
}

}  // namespace
}  // namespace fiberfate
