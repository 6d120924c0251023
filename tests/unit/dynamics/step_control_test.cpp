// Tests how the size of a time step is proposed, accepted and adapted.
#include "dynamics/step_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <limits>

namespace fiberfate {
namespace {

const Flow rest = simple_shear(0, 200);
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ProposeStep, DividesTheTimeToAnEventEvenly) {
  const StepParameters parameters;
  const StepChoice choice = propose_step(parameters, 1e-4, rest, 2.5e-4);
  EXPECT_NEAR(choice.size, 2.5e-4 / 3, 1e-18);
  EXPECT_EQ(choice.limit, StepLimit::tolerance);
}

TEST(ProposeStep, StopsAtAnEvent) {
  const StepChoice choice = propose_step({}, 1e-4, rest, 3e-5);
  EXPECT_EQ(choice.size, 3e-5);
  EXPECT_EQ(choice.limit, StepLimit::event);
}

TEST(ProposeStep, BoundsStrainAndSize) {
  StepParameters parameters;
  parameters.maximum_strain = 0.02;
  const StepChoice strained = propose_step(parameters, 1e-2, simple_shear(100, 200), 1);
  EXPECT_NEAR(strained.size * 100, 0.02, 1e-12);
  EXPECT_EQ(strained.limit, StepLimit::strain);
  parameters.maximum = 1e-4;
  const StepChoice bounded = propose_step(parameters, 1e-2, rest, 1);
  EXPECT_NEAR(bounded.size, 1e-4, 1e-12);
  EXPECT_EQ(bounded.limit, StepLimit::maximum);
}

TEST(ProposeStep, TakesAFixedStepAsItIs) {
  StepParameters parameters;
  parameters.control = StepControl::fixed;
  parameters.initial = 2e-5;
  const StepChoice choice = propose_step(parameters, 0.3, simple_shear(1e6, 200), 1);
  EXPECT_NEAR(choice.size, 2e-5, 1e-12);
  EXPECT_EQ(choice.limit, StepLimit::control);
}

TEST(IsAcceptable, LetsThroughTwiceTheToleranceAndNothingThatIsNotFinite) {
  StepParameters parameters;
  EXPECT_TRUE(is_acceptable(parameters, 1.99 * parameters.tolerance));
  EXPECT_FALSE(is_acceptable(parameters, 2.01 * parameters.tolerance));
  parameters.control = StepControl::fixed;
  EXPECT_TRUE(is_acceptable(parameters, 1e9));
  EXPECT_FALSE(is_acceptable(parameters, infinity));
}

// The error of a smooth motion goes with the square of the step: four times the tolerance asks for half the
// step.
TEST(StepSize, FollowsTheErrorsSquareRoot) {
  const StepParameters parameters;
  const double half = shrunk_step(parameters, 1e-4, 4 * parameters.tolerance);
  EXPECT_NEAR(half, 0.45e-4, 1e-10);
  const double next = next_proposal(parameters, {1e-4, StepLimit::tolerance}, 1e-4, 4 * parameters.tolerance);
  EXPECT_NEAR(next, 0.45e-4, 1e-10);
  EXPECT_LT(shrunk_step(parameters, 1e-4, infinity), 0.5e-4);
  EXPECT_GT(next_proposal(parameters, {1e-4, StepLimit::tolerance}, 1e-4, 0), 1e-4);
}

TEST(StepSize, IsNotForgottenWhenAnEventCutsAStepShort) {
  const StepParameters parameters;
  EXPECT_EQ(next_proposal(parameters, {1e-7, StepLimit::event}, 1e-4, 0), 1e-4);
}

// Between checks every millisecond steps are cut to equal parts; the longest part whose error is tolerable
// must be found, and not the one at which growth happened to arrive.
TEST(StepSize, GrowsPastThePartsThatEventsCut) {
  StepParameters parameters;
  parameters.maximum = 1;
  const auto settled = [&](double tolerable) {
    StepChoice choice;
    double proposal = 1e-5;
    double now = 0;
    for (int i = 0; i < 2000; ++i) {
      const double event = 1e-3 * std::floor(now * 1e3 + 1 + 1e-6);
      choice = propose_step(parameters, proposal, rest, event - now);
      proposal = next_proposal(parameters, choice, proposal,
                               parameters.tolerance * std::pow(choice.size / tolerable, 2));
      now += choice.size;
    }
    return choice.size;
  };
  EXPECT_NEAR(settled(4e-4), 1e-3 / 3, 1e-9);
  EXPECT_NEAR(settled(6e-4), 1e-3 / 2, 1e-9);
  EXPECT_NEAR(settled(3e-4), 1e-3 / 4, 1e-9);
  EXPECT_NEAR(settled(2e-3), 1e-3, 1e-9);
}

TEST(StepSize, StaysBetweenItsBounds) {
  const StepParameters parameters;
  EXPECT_EQ(next_proposal(parameters, {parameters.maximum, StepLimit::tolerance}, 1, 0), parameters.maximum);
  EXPECT_EQ(next_proposal(parameters, {parameters.minimum, StepLimit::tolerance}, 1, 1e9),
            parameters.minimum);
}

}  // namespace
}  // namespace fiberfate
