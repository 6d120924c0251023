// A simulation made from a state in mid-run continues as if it had never stopped, bit by bit.
#include <gtest/gtest.h>

#include "reference/bitwise_state.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

DynamicsParameters with_breakage(std::string law) {
  DynamicsParameters parameters;
  parameters.breakage.law = law;
  parameters.breakage.critical_radius = 200e-6;
  parameters.breakage.maximum_radius = 400e-6;
  parameters.breakage.check_interval = 3e-4;
  return parameters;
}

class RestartInvariance : public testing::TestWithParam<std::string> {};

TEST_P(RestartInvariance, FromAnyStep) {
  const FiberState start = scenes::scatter(scenes::soft_fibers());
  const FlowHistory flow(
      {{0, simple_shear(100, 500)}, {2e-3, simple_shear(300, 300)}, {8e-3, simple_shear(250, 500)}});
  const DynamicsParameters parameters = with_breakage(GetParam());
  Simulation whole(parameters, flow, start);
  std::vector<FiberState> saved;
  const double end = 1.5e-2;
  while (whole.state().time < end) {
    whole.advance(end);
    if (whole.state().step % 61 == 3) saved.push_back(whole.state());
  }
  ASSERT_GT(whole.state().breaks, 5);
  ASSERT_GT(saved.size(), 2u);
  for (const FiberState& state : saved) {
    Simulation resumed(parameters, flow, state);
    scenes::run_until(resumed, end);
    expect_bitwise_equal(whole.state(), resumed.state());
    if (HasFailure()) FAIL() << "resumed at step " << state.step << " of " << whole.state().step;
  }
}
INSTANTIATE_TEST_SUITE_P(Laws, RestartInvariance, testing::Values("fixed", "probability", "strength"));

}  // namespace
}  // namespace fiberfate
