// Tests flow histories.
#include "fibers/flow.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.hpp"

namespace fiberfate {
namespace {

TEST(Flow, SplitsIntoStrainAndRotation) {
  const Flow flow = simple_shear(16.65, 200);
  EXPECT_EQ(flow.gradient(0, 1), 16.65);
  EXPECT_EQ(flow.rate_of_strain()(0, 1), 16.65 / 2);
  EXPECT_TRUE(flow.angular_velocity().isApprox(Vec3(0, 0, -16.65 / 2)));
  const Vec3 p(0.3, -0.4, 0.5);
  const Mat3 spin = 0.5 * (flow.gradient - flow.gradient.transpose());
  EXPECT_TRUE((spin * p).isApprox(flow.angular_velocity().cross(p)));
}

TEST(FlowHistory, HoldsEachIntervalUntilItsEnd) {
  const FlowHistory history({{1.0, 10, 100}, {2.0, 20, 200}, {3.0, 30, 300}});
  EXPECT_EQ(history.at(0).gradient(0, 1), 10);
  EXPECT_EQ(history.at(1.0).gradient(0, 1), 20) << "an interval ends before its end time";
  EXPECT_EQ(history.at(99).viscosity, 300) << "the last one lasts";
  EXPECT_EQ(history.next_change(0.5), 1.0);
  EXPECT_EQ(history.next_change(1.0), 2.0);
  EXPECT_EQ(history.next_change(2.5), std::numeric_limits<double>::infinity());
}

TEST(FlowHistory, RampsInEqualSteps) {
  const FlowHistory history = FlowHistory::ramp(16.65, 200, 1.0, 10);
  EXPECT_DOUBLE_EQ(history.at(0).gradient(0, 1), 1.665);
  EXPECT_DOUBLE_EQ(history.at(0.55).gradient(0, 1), 6 * 1.665);
  EXPECT_DOUBLE_EQ(history.at(1.5).gradient(0, 1), 16.65);
  EXPECT_EQ(history.next_change(0.95), 1.0);
}

TEST(FlowHistory, RefusesDisorder) {
  EXPECT_THROW(FlowHistory({}), InputError);
  EXPECT_THROW(FlowHistory({{1, 1, 1}, {1, 2, 1}}), InputError);
  EXPECT_THROW(FlowHistory({{1, 1, 0}}), InputError);
}

}  // namespace
}  // namespace fiberfate
