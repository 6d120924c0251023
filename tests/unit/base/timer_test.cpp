// Tests the measurement of time and memory.
#include "base/timer.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace fiberfate {
namespace {

TEST(PhaseTimes, SumsByPhase) {
  PhaseTimes times;
  times.add(Phase::solve, 1.5);
  times.add(Phase::solve, 0.25);
  EXPECT_DOUBLE_EQ(times.seconds(Phase::solve), 1.75);
  EXPECT_DOUBLE_EQ(times.seconds(Phase::loads), 0.0);
}

TEST(PhaseTimer, AddsItsOwnLife) {
  PhaseTimes times;
  const double before = wall_seconds();
  {
    const PhaseTimer timer(times, Phase::output);
    while (wall_seconds() < before + 2e-3) {
    }
  }
  EXPECT_GT(times.seconds(Phase::output), 1e-3);
  EXPECT_LE(times.seconds(Phase::output), wall_seconds() - before + 1e-6);
}

TEST(Process, KnowsItsMemory) {
  const std::size_t before = peak_memory_bytes();
  EXPECT_GT(before, std::size_t{1} << 20);
  std::vector<char> block(std::size_t{64} << 20, 'x');
  // Clang leaves out a block that nobody could have seen.
  const char* volatile seen = block.data();
  EXPECT_EQ(seen[block.size() / 2], 'x');
  EXPECT_GE(peak_memory_bytes(), before + (std::size_t{32} << 20));
}

}  // namespace
}  // namespace fiberfate
