// Tests means of correlated series against an autoregressive process, whose errors are known.
#include "calibration/block_average.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"

namespace fiberfate {
namespace {

/// x_{i+1} = memory x_i + noise of variance 1.
std::vector<double> autoregressive(double memory, std::size_t count, std::uint64_t seed) {
  std::vector<double> values;
  double x = normal2(seed, RandomStream::noise, {0, 1})[0] / std::sqrt(1 - memory * memory);
  for (std::size_t i = 0; i < count; ++i) {
    x = memory * x + normal2(seed, RandomStream::noise, {static_cast<std::uint32_t>(i), 0})[0];
    values.push_back(x);
  }
  return values;
}

TEST(BlockMean, KnowsTheErrorOfCorrelatedValues) {
  for (const double memory : {0.0, 0.5, 0.9}) {
    const std::size_t count = 1 << 13;
    const double expected = 1 / ((1 - memory) * std::sqrt(static_cast<double>(count)));
    const double time = 0.5 * (1 + memory) / (1 - memory);
    double error = 0, correlation = 0, covered = 0;
    constexpr int series = 60;
    for (int i = 0; i < series; ++i) {
      const std::vector<double> values = autoregressive(memory, count, 100 + i);
      const BlockMean found = block_mean(values);
      error += found.error / series;
      correlation += found.autocorrelation / series;
      covered += std::abs(found.mean) < 2 * found.error ? 1.0 / series : 0;
    }
    EXPECT_NEAR(error, expected, 0.12 * expected) << memory;
    EXPECT_NEAR(correlation, time, 0.2 * time) << memory;
    EXPECT_GE(covered, 0.85) << memory;
  }
}

TEST(BlockMean, OfAFewValuesHasNoError) {
  const std::vector<double> values = {1, 2, 3};
  EXPECT_EQ(block_mean(values).mean, 2);
  EXPECT_TRUE(std::isnan(block_mean(values).error));
  EXPECT_EQ(block_mean({}).values, 0U);
}

TEST(BlockMean, OfAConstantIsCertain) {
  const std::vector<double> values(100, 3.5);
  EXPECT_EQ(block_mean(values).mean, 3.5);
  EXPECT_EQ(block_mean(values).error, 0);
}

}  // namespace
}  // namespace fiberfate
