// Tests when a filling is at its end.
#include "molding/step_control.hpp"

#include <gtest/gtest.h>

namespace fiberfate {
namespace {

ShellMesh square() {
  return ShellMesh(
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {0.002, 0.002}, {}, {}});
}

constexpr double rate = 1e-3;  // the cavity of 2e-3 m³ takes 2 s

FillingParams params() {
  FillingParams params;
  params.process.flow = FlowProfile::constant(rate);
  return params;
}

/// A cavity that is full but for a share, under a pressure that moves `flow`.
FillingState nearly_full(double missing, double flow) {
  FillingState state;
  state.filled = {1, 1, 1, 1};
  state.excess = {0, 0, 0, 0};
  state.rate.assign(8, 0.0);
  state.injected_volume = state.filled_volume = 2e-3 * (1 - missing);
  state.flow_rate = flow;
  return state;
}

FlowField limited() {
  FlowField field;
  field.limited = true;
  field.inverse_viscosity.assign(8, 1e-2);
  return field;
}

FillingEnd reason(const FillingState& state) {
  return reason_to_stop(params(), square(), state, limited());
}

TEST(FillingEnds, AShotIsShortWherePressureNoLongerMovesTheMelt) {
  EXPECT_EQ(reason(nearly_full(0.1, 2e-3 * rate)), FillingEnd::none);
  EXPECT_EQ(reason(nearly_full(0.1, 0.9e-3 * rate)), FillingEnd::short_shot);
  EXPECT_EQ(reason(nearly_full(0.1, 0)), FillingEnd::short_shot);
}

TEST(FillingEnds, ALastCornerMayFillSlowly) {
  // What is missing takes 0.2 s, or 20 s, at this rate; the filling was to take 2 s.
  EXPECT_EQ(reason(nearly_full(1e-5, 1e-4 * rate)), FillingEnd::none);
  EXPECT_EQ(reason(nearly_full(1e-5, 1e-6 * rate)), FillingEnd::short_shot);
}

/// All melt is in: what some nodes hold too much is on its way, though no machine drives it.
TEST(FillingEnds, MeltThatIsInIsNoShortShot) {
  FillingState state = nearly_full(0, 0);
  state.filled_volume = 2e-3 * (1 - 1e-6);
  state.excess[0] = 2e-9;
  EXPECT_EQ(reason(state), FillingEnd::none);
  state.excess[0] = 0;
  EXPECT_EQ(reason(state), FillingEnd::filled);
}

}  // namespace
}  // namespace fiberfate
