// Tests the finer times at which fitted curves are drawn.
#include <gtest/gtest.h>

#include "studies/calibration/model.hpp"

namespace fiberfate {
namespace {

/// Bands of a fit take the deviation that an observation would have at their own time, not a mean one.
TEST(RefinedSeries, InterpolatesDeviationsWhateverTheOrderOfTheTimes) {
  MeasuredSeries series;
  series.observed = Observed::number_average;
  series.times = {4, 1, 2};
  series.values = {1, 3, 2};
  series.deviations = {0.1, 0.4, 0.2};
  const MeasuredSeries fine = refined(series, 5);  // 0, 1, 2, 3, 4
  ASSERT_EQ(fine.times.size(), 5U);
  EXPECT_DOUBLE_EQ(fine.times[3], 3);
  const std::vector<double> wanted = {0.4, 0.4, 0.2, 0.15, 0.1};
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_DOUBLE_EQ(fine.deviations[i], wanted[i]) << i;
}

}  // namespace
}  // namespace fiberfate
