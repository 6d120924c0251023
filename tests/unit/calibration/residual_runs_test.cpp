// Checks how runs of residuals are counted.
#include <gtest/gtest.h>

#include <cmath>

#include "calibration/residual_runs.hpp"

namespace fiberfate {
namespace {

TEST(ResidualRuns, CountChangesOfSign) {
  const std::vector<std::vector<double>> series = {{1, 2, -1, -2, -3, 1, 0, 4}, {-1, 1}};
  const ResidualRuns found = count_runs(series);
  EXPECT_EQ(found.runs, 3 + 2);
  EXPECT_EQ(found.expected, (1 + 3.5) + (1 + 0.5));
  EXPECT_NEAR(found.deviations, (5 - 6) / std::sqrt(0.25 * 8), 1e-15);
}

TEST(ResidualRuns, TellALawThatBendsElsewhere) {
  std::vector<double> bent, alternating;
  for (int i = 0; i < 20; ++i) {
    bent.push_back(std::cos(0.15 * i));
    alternating.push_back(i % 2 == 0 ? 1 : -1);
  }
  EXPECT_LT(count_runs(std::vector<std::vector<double>>{bent}).deviations, -3);
  EXPECT_GT(count_runs(std::vector<std::vector<double>>{alternating}).deviations, 3);
}

TEST(ResidualRuns, SayNothingOfFewResiduals) {
  EXPECT_TRUE(std::isnan(count_runs(std::vector<std::vector<double>>{{1, 1, 1}, {2}}).deviations));
  EXPECT_EQ(count_runs({}).runs, 0);
}

}  // namespace
}  // namespace fiberfate
