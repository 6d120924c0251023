// Checks at which times rows of series.csv stand.
#include <gtest/gtest.h>

#include "studies/run_choices.hpp"

namespace fiberfate {
namespace {

using Times = std::vector<double>;

RunChoices lasting(double duration) {
  RunChoices run;
  run.duration = duration;
  return run;
}

TEST(SeriesTimes, AreMultiplesOfTheIntervalAndTheEnd) {
  EXPECT_EQ(series_times(lasting(1), {0.4, {}}), (Times{0, 0.4, 0.8, 1}));
  EXPECT_EQ(series_times(lasting(2), {}).size(), 201U);
}

TEST(SeriesTimes, ChosenOnesStandAloneOrBesideTheInterval) {
  EXPECT_EQ(series_times(lasting(9), {{}, {5, 1}}), (Times{0, 1, 5, 9}));
  EXPECT_EQ(series_times(lasting(9), {4, {5, 1}}), (Times{0, 1, 4, 5, 8, 9}));
  EXPECT_EQ(series_times(lasting(9), {{}, {5}}, {2, 5}), (Times{0, 2, 5, 9}));
}

TEST(SeriesTimes, AreThoseAskedForWhereRoundOffPartsThemFromMultiples) {
  ASSERT_NE(3 * 0.3, 0.9);
  EXPECT_EQ(series_times(lasting(0.9), {0.3, {}}).back(), 0.9);
  EXPECT_EQ(series_times(lasting(1.2), {0.3, {0.9}}), (Times{0, 0.3, 0.6, 0.9, 1.2}));
  EXPECT_EQ(series_times(lasting(1.2), {0.3, {}}, {0.9}), (Times{0, 0.3, 0.6, 0.9, 1.2}));
}

}  // namespace
}  // namespace fiberfate
