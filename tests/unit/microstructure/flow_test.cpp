// Tests flows and flow histories.
#include "microstructure/flow_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

/// Simple shear of a melt at a temperature.
Flow warm_shear(double rate, double temperature) {
  return {simple_shear(rate).gradient, 0, temperature};
}

TEST(Flow, HasTheShearRateThatMadeIt) {
  for (const double rate : {1e-3, 18.326, 1e6}) EXPECT_EQ(simple_shear(rate).shear_rate(), rate);
  EXPECT_EQ(simple_shear(-7).shear_rate(), 7);
  for (const Mat3& gradient : {simple_shear_gradient(), planar_elongation_gradient(),
                               uniaxial_elongation_gradient(), biaxial_elongation_gradient()})
    EXPECT_NEAR(Flow{gradient}.shear_rate(), 1, 1e-15);
}

TEST(FlowHistory, HoldsEachStepUntilTheNext) {
  const FlowHistory history(
      {{0, simple_shear(10, 100)}, {1, simple_shear(20, 200)}, {2, simple_shear(30, 300)}});
  EXPECT_EQ(history.at(0).gradient(0, 1), 10);
  EXPECT_EQ(history.at(1.0).gradient(0, 1), 20);
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

TEST(FlowHistory, CutsStepsExactly) {
  const FlowHistory history({{0, warm_shear(10, 500)}, {2, warm_shear(30, 520)}});
  const std::vector<FlowPart> parts = history.parts(1, 7);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].duration, 1);
  EXPECT_EQ(parts[1].duration, 5);
  EXPECT_EQ(parts[1].flow.temperature, 520);
}

TEST(FlowHistory, CutsRampsFinely) {
  const FlowHistory history({{0, warm_shear(0, 400)}, {2, warm_shear(10, 500)}}, HistoryForm::ramps);
  EXPECT_EQ(history.at(0.5).gradient(0, 1), 2.5);
  EXPECT_EQ(history.at(0.5).temperature, 425);
  double time = 0, strain = 0;
  for (const FlowPart& part : history.parts(0.3, 5)) {
    time += part.duration;
    strain += part.duration * part.flow.gradient(0, 1);
  }
  EXPECT_NEAR(time, 4.7, 1e-14);
  EXPECT_NEAR(strain, 10 - 2.5 * 0.09 + 30, 1e-12);
}

TEST(FlowHistory, TurnsRampsIntoStepsOfTheSameStrain) {
  const FlowHistory ramp({{0, simple_shear(4)}, {1, simple_shear(10)}, {3, simple_shear(2)}},
                         HistoryForm::ramps);
  EXPECT_THROW(require_steps(ramp), InputError);
  const FlowHistory steps = ramp.in_steps(4);
  require_steps(steps);
  ASSERT_EQ(steps.rows().size(), 9U);
  EXPECT_EQ(steps.at(0.1).gradient(0, 1), 4 + 6.0 / 8) << "the middle of the first quarter";
  EXPECT_EQ(steps.next_change(0.1), 0.25);
  EXPECT_EQ(steps.at(100).gradient(0, 1), 2);
  double strain = 0;
  for (const FlowPart& part : steps.parts(0, 3)) strain += part.duration * part.flow.gradient(0, 1);
  EXPECT_NEAR(strain, 7 + 12, 1e-13);
}

TEST(FlowHistory, RepeatsForEver) {
  const FlowHistory history = FlowHistory::repeated({{0, simple_shear(1)}, {0.1, simple_shear(-1)}}, 0.3);
  EXPECT_EQ(history.at(0.05).gradient(0, 1), 1);
  EXPECT_EQ(history.at(30.2).gradient(0, 1), -1);
  // Whoever steps from change to change meets every one, whatever is rounded.
  double time = 0;
  for (int i = 0; i < 20000; ++i) {
    EXPECT_EQ(history.at(time).gradient(0, 1), i % 2 == 0 ? 1 : -1) << time;
    const double next = history.next_change(time);
    ASSERT_GT(next, time + 0.09);
    time = next;
  }
  EXPECT_NEAR(time, 3000, 1e-9);
  double strain = 0;
  for (const FlowPart& part : history.parts(0, 300)) strain += part.duration * part.flow.gradient(0, 1);
  EXPECT_NEAR(strain, -100, 1e-9);
  EXPECT_THROW(FlowHistory::repeated({{0, simple_shear(1)}, {0.1, simple_shear(2)}}, 0.1), InputError);
}

TEST(FlowHistory, RefusesDisorder) {
  const Flow shear = simple_shear(1, 1);
  EXPECT_THROW(FlowHistory(std::vector<FlowRow>{}), InputError);
  EXPECT_THROW(FlowHistory({{1, shear}}), InputError) << "what happens before?";
  EXPECT_THROW(FlowHistory({{0, shear}, {0, shear}}), InputError);
  EXPECT_THROW(FlowHistory({{0, simple_shear(NAN, 1)}}), InputError);
  EXPECT_THROW(FlowHistory({{0, simple_shear(1, -1)}}), InputError);
  EXPECT_THROW((void)FlowHistory::constant(1, 1).parts(2, 1), InputError);
}

}  // namespace
}  // namespace fiberfate
