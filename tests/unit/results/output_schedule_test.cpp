// Tests that outputs are due at exact times, each once, with or without an interruption.
#include "results/output_schedule.hpp"

#include <gtest/gtest.h>

namespace fiberfate {
namespace {

TEST(OutputSchedule, VisitsEveryMultipleOnce) {
  const OutputSchedule schedule{0.1, {}};
  double time = 0;
  for (int k = 1; k <= 10000; ++k) {
    time = schedule.next(time);
    ASSERT_EQ(time, k * 0.1);
    ASSERT_TRUE(schedule.includes(time));
  }
}

TEST(OutputSchedule, DoesNotDependOnWhereARunWasResumed) {
  const OutputSchedule schedule{0.1, {}};
  EXPECT_EQ(schedule.next(0.2500001), 3 * 0.1);
  EXPECT_EQ(schedule.next(0.29), 3 * 0.1);
}

TEST(OutputSchedule, TakesTimesThatDifferByRoundOffForOne) {
  const OutputSchedule schedule{0.1, {}};
  EXPECT_EQ(schedule.next(0.3), 4 * 0.1) << "3 x 0.1 is 0.3 and some round-off";
  EXPECT_TRUE(schedule.includes(0.3));
  EXPECT_FALSE(schedule.includes(0.301));
  EXPECT_EQ(schedule.snapped(0.3), 3 * 0.1);
  EXPECT_EQ(schedule.snapped(0.35), 0.35);
}

TEST(OutputSchedule, AddsOtherTimes) {
  const OutputSchedule schedule{0.1, {0.25, 0.3, 0.02}};
  EXPECT_EQ(schedule.next(0), 0.02);
  EXPECT_EQ(schedule.next(0.02), 0.1);
  EXPECT_EQ(schedule.next(0.2), 0.25);
  EXPECT_EQ(schedule.next(0.25), 3 * 0.1);
  EXPECT_TRUE(schedule.includes(0.25));
}

}  // namespace
}  // namespace fiberfate
