// Tests the visit of nodes down the flow.
#include "molding/sweep.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

TEST(Sweep, SmallLevelsAreHalvedAndLargeOnesCutIntoEvenNumbers) {
  EXPECT_EQ(nodes_of_a_part(1), 1u);
  EXPECT_EQ(nodes_of_a_part(14), 7u);
  EXPECT_EQ(nodes_of_a_part(32), 16u);
  EXPECT_EQ(nodes_of_a_part(33), 9u);
  for (std::size_t level = 1; level < 300; ++level) {
    EXPECT_LE(nodes_of_a_part(level), 16u);
    EXPECT_GE(4 * nodes_of_a_part(level), std::min<std::size_t>(level, 32));
  }
}

/// Every node is visited once, and only when all nodes of the levels before are done.
TEST(Sweep, LevelsFollowEachOtherOnAnyThreads) {
  StepFlow step;
  step.level_begin = {0, 5, 6, 76, 109};
  step.order.resize(109);
  std::iota(step.order.begin(), step.order.end(), 0);
  const int before = thread_count();
  use_threads(3);
  std::vector<std::atomic<int>> visits(109);
  std::atomic<int> early = 0;
  sweep_down_the_flow(step, [&](std::span<const Index> nodes) {
    for (const Index node : nodes) {
      std::size_t level = 0;
      while (step.level_begin[level + 1] <= static_cast<std::size_t>(node)) ++level;
      for (std::size_t upstream = 0; upstream < step.level_begin[level]; ++upstream)
        if (visits[upstream] == 0) ++early;
    }
    for (const Index node : nodes) ++visits[static_cast<std::size_t>(node)];
  });
  use_threads(before);
  EXPECT_EQ(early, 0);
  for (const auto& count : visits) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace fiberfate
