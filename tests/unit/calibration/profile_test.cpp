// Tests profiles of the likelihood that a linearised interval knows nothing of: two minima, a better fit
// elsewhere.
#include "calibration/profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "calibration/fit.hpp"

namespace fiberfate {
namespace {

bool tells(const Profile& profile, FindingKind kind) {
  for (const Finding& finding : profile.findings)
    if (finding.kind == kind) return true;
  return false;
}

std::vector<double> ones(std::size_t count) {
  return std::vector<double>(count, 1.0);
}

TEST(Profile, OfALinearModelIsItsLinearisedIntervalWithoutFindings) {
  FitProblem problem;
  problem.parameters = {{.name = "a", .initial = 1}, {.name = "b", .initial = 1}};
  problem.series = {{"y", "1", {1.1, 1.9, 3.2, 3.9, 5.1}, ones(5)}};
  problem.model = [](std::span<const double> p, std::span<double> y) {
    for (std::size_t i = 0; i < 5; ++i) y[i] = p[0] + p[1] * static_cast<double>(i);
  };
  const FitResult found = fit(problem);
  const Profile profiled = profile(problem, found, 1);
  EXPECT_NEAR(profiled.interval.lower, found.parameters[1].interval.lower, 2e-4);
  EXPECT_NEAR(profiled.interval.upper, found.parameters[1].interval.upper, 2e-4);
  EXPECT_TRUE(profiled.findings.empty());
}

/// chi^2(a, b) has two valleys over a, near b = -1 and b = 1 (their floors 0.1 b apart in a), so that the
/// lowest one changes on the way: with b free, the profile over a has a kink where b jumps.
FitProblem two_valleys() {
  FitProblem problem;
  problem.parameters = {{.name = "a", .initial = 1.5, .lower = -20, .upper = 20},
                        {.name = "b", .initial = 1, .lower = -3, .upper = 3}};
  problem.series = {{"y", "1", {0, 0}, ones(2)}};
  problem.noise = NoiseScale::known;
  problem.model = [](std::span<const double> p, std::span<double> y) {
    y[0] = p[0] - 1.5 * p[1];                   // the floor of a valley: a = 1.5 b
    y[1] = 4 * (p[1] * p[1] - 1) + 0.3 * p[1];  // b = ±1, a little different in depth
  };
  return problem;
}

TEST(Profile, FollowsTheLowerOfTwoValleysAndSaysWhereItJumps) {
  const FitProblem problem = two_valleys();
  const FitResult found = fit(problem);
  ASSERT_TRUE(found.converged);
  const Profile profiled = profile(problem, found, 0);
  EXPECT_TRUE(tells(profiled, FindingKind::several_minima));
  // Valleys at a = ±1.5 with the 95 % quantile of the normal distribution, 1.96, on their outer sides; a
  // search that stayed in the valley of the fit would end near -0.4.
  EXPECT_LT(profiled.interval.lower, -3.0);
  EXPECT_GT(profiled.interval.upper, 3.0);
  EXPECT_NEAR(profiled.interval.lower, -3.45, 0.25);
  EXPECT_NEAR(profiled.interval.upper, 3.45, 0.25);
}

/// Two valleys, the one in which the search began not the lower one: the interval must not be its own.
TEST(Profile, TellsOfABetterFitAndGivesItsInterval) {
  FitProblem problem;
  problem.parameters = {{.name = "a", .initial = 3, .lower = -20, .upper = 20}};
  problem.series = {{"y", "1", {0, 0}, ones(2)}};
  problem.noise = NoiseScale::known;
  problem.model = [](std::span<const double> p, std::span<double> y) {
    y[0] = (p[0] - 3) * (p[0] + 3) / 6;
    y[1] = 0.2 * (p[0] + 3);
  };
  FitOptions wide;
  wide.level = 0.999;  // the walk from the wrong valley has to pass the hill between
  const FitResult found = fit(problem, wide);
  ASSERT_GT(found.values[0], 0);
  const Profile profiled = profile(problem, found, 0, wide);
  EXPECT_TRUE(tells(profiled, FindingKind::better_fit));
  EXPECT_LT(profiled.interval.lower, -3);
}

TEST(Profile, RefusesWhatItCannotProfile) {
  FitProblem problem = two_valleys();
  problem.parameters[1].role = ParameterRole::fixed;
  const FitResult found = fit(problem);
  EXPECT_THROW(static_cast<void>(profile(problem, found, 1)), InputError);
  FitOptions impossible;
  impossible.level = 1;
  EXPECT_THROW(static_cast<void>(profile(problem, found, 0, impossible)), InputError);
  EXPECT_THROW(static_cast<void>(fit(problem, impossible)), InputError);
}

}  // namespace
}  // namespace fiberfate
