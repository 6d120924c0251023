// Tests that a trial of a part foretells the whole.
#include "studies/pace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace fiberfate {
namespace {

/// Keeps the processor busy: what is foretold does not count the time that other programs take.
void work(int milliseconds) {
  const Stopwatch watch;
  while (watch.elapsed() < 1e-3 * milliseconds) {
  }
}

TEST(Pace, ForetellsSteadyWork) {
  Pace pace(0.05);
  for (double share = 0; pace.has_time(); pace.reached(share += 0.01)) work(2);
  EXPECT_GT(pace.whole(), 0.15);
  EXPECT_LT(pace.whole(), 0.6);
}

TEST(Pace, LeavesTheBeginningOutOfTheSpeed) {
  Pace pace(10);
  work(40);
  pace.reached(0.01);
  for (int i = 2; i <= 21; ++i) {
    work(2);
    pace.reached(0.01 * i);
  }
  EXPECT_LT(pace.whole(), 0.7);  // 0.08 s and 79 more steps of 2 ms; as a whole it would be above 0.38 s
  EXPECT_GT(pace.whole(), 0.2);
}

TEST(Pace, EndsATrialThatWaits) {
  Pace pace(1e-3);
  int parts = 0;
  for (; pace.has_time(); ++parts) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_LE(parts, 3);
}

TEST(Pace, MeasuresWhatIsDoneWithinTheTrial) {
  Pace pace;
  work(5);
  pace.reached(1);
  EXPECT_DOUBLE_EQ(pace.whole(), pace.elapsed());
}

TEST(Pace, KnowsNothingBeforeItBegins) {
  EXPECT_EQ(Pace().whole(), 0);
}

TEST(EarlyTimes, RiseToTheFirstOne) {
  const std::vector<double> times = with_early_times({0, 8, 16});
  EXPECT_EQ(times.front(), 0);
  EXPECT_EQ(times[1], 0.125);
  EXPECT_EQ(std::vector<double>(times.end() - 3, times.end()), (std::vector<double>{4, 8, 16}));
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
}

}  // namespace
}  // namespace fiberfate
