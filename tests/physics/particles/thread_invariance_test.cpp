// The number of threads changes not one bit of the answer.
#include <gtest/gtest.h>

#include "base/threads.hpp"
#include "reference/bitwise_state.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

DynamicsParameters with_breakage() {
  DynamicsParameters parameters;
  parameters.breakage.law = "probability";
  parameters.breakage.maximum_radius = 400e-6;
  parameters.breakage.check_interval = 2e-4;
  return parameters;
}

struct Outcome {
  FiberState state;
  std::vector<BreakEvent> events;
};

Outcome run(const FiberState& start, int threads) {
  const int before = thread_count();
  use_threads(threads);
  Simulation simulation(with_breakage(), FlowHistory::constant(300, 500), start);
  scenes::run_until(simulation, 1e-2);
  Outcome outcome{simulation.state(), simulation.take_break_events()};
  use_threads(before);
  return outcome;
}

TEST(ThreadInvariance, OfAClusterThatTouchesAndBreaks) {
  // Small populations are stepped by one thread (SuitableThreads): 2400 rods keep three busy.
  scenes::Scatter many_fibers = scenes::soft_fibers();
  many_fibers.cell *= std::cbrt(200.0 / many_fibers.fibers);
  many_fibers.fibers = 200;
  const FiberState start = scenes::scatter(many_fibers);
  const Outcome one = run(start, 1);
  EXPECT_GT(one.state.breaks, 10) << "without breaks less is tested";
  EXPECT_GT(one.state.step, 20);
  for (const int threads : {2, 3}) {
    const Outcome many = run(start, threads);
    expect_bitwise_equal(one.state, many.state);
    ASSERT_EQ(one.events.size(), many.events.size());
    for (std::size_t i = 0; i < one.events.size(); ++i) {
      EXPECT_EQ(one.events[i].birth_id, many.events[i].birth_id);
      EXPECT_EQ(one.events[i].birth_node, many.events[i].birth_node);
      EXPECT_EQ(one.events[i].radius, many.events[i].radius);
    }
  }
}

}  // namespace
}  // namespace fiberfate
