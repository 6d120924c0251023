// Steady orientations: Newton's method finds what a long run comes to, and says in words where there is
// nothing to find.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/orientation_steady.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

/// Constants of the usual size for every diffusion.
OrientationModel model_with(RotaryDiffusion diffusion, Retardation retardation, Closure closure) {
  OrientationModel model{diffusion, retardation, closure, {}};
  OrientationConstants& c = model.constants;
  const std::string law = name(diffusion);
  if (law == "ard") c.b1 = 0.01, c.b2 = 0.002, c.b3 = 0.005, c.b4 = 0.001, c.b5 = 0.01;
  if (law == "wpt") c.b1 = 0.01, c.b3 = 0.01;
  if (law == "folgar_tucker" || law == "iard" || law == "pard" || law == "mrd") c.c_i = 0.02;
  if (law == "iard") c.c_m = 0.6;
  if (law == "pard") c.omega = 0.7;
  if (law == "mrd") c.d2 = 0.6, c.d3 = 0.3;
  if (retardation == retardation_named("rsc")) c.kappa = 0.3;
  if (retardation == retardation_named("rpr")) c.alpha = 0.7;
  if (retardation == retardation_named("srf")) c.srf = 0.3;
  return model;
}

Mat3 after_a_long_run(const OrientationModel& model, const Mat3& gradient, double duration) {
  OrientationIntegrator integrator(OrientationLaw(model), FlowHistory::constant({gradient}), {},
                                   {.absolute = 1e-11, .relative = 1e-11});
  integrator.advance_to(duration);
  return integrator.state().second;
}

std::string label(const OrientationModel& model) {
  return std::string(name(model.diffusion)) + "+" + name(model.retardation) + " " + name(model.closure);
}

/// A run of 60 decay times leaves e^-60; what differs then is the error of the run's steps, 1e-11 each, and
/// the round-off of the fitted closures (their polynomials have coefficients of 1e10).
constexpr double run_tolerance = 1e-8;

TEST(SteadyOrientation, IsWhatALongRunComesTo) {
  int compared = 0;
  for (const auto& diffusion : rotary_diffusions()) {
    if (diffusion.choice == rotary_diffusion_named("jeffery")) continue;
    for (const auto& retardation : retardations()) {
      for (const Closure closure :
           {closure_named("hybrid"), closure_named("ibof"), closure_named("orw3"), closure_named("ore")}) {
        const OrientationModel model = model_with(diffusion.choice, retardation.choice, closure);
        for (const Mat3& gradient : {simple_shear_gradient(), planar_elongation_gradient()}) {
          SteadyOrientation steady;
          ASSERT_NO_THROW(steady = steady_orientation(model, 5 * gradient)) << label(model);
          const Mat3 run = after_a_long_run(model, 5 * gradient, 60 / steady.decay_rate);
          EXPECT_LT((steady.second - run).norm(), run_tolerance) << label(model);
          EXPECT_LT(steady.residual, 5e-9) << label(model);
          ++compared;
        }
      }
    }
  }
  EXPECT_EQ(compared, 6 * 4 * 4 * 2);
}

TEST(SteadyOrientation, EveryClosureHasItsOwnInShear) {
  for (const ClosureDescription& one : closures()) {
    const OrientationModel model =
        model_with(rotary_diffusion_named("folgar_tucker"), retardation_named("none"), one.closure);
    SteadyOrientation steady;
    try {
      steady = steady_orientation(model, simple_shear_gradient());
    } catch (const SimulationFailure& failure) {
      // Linear and peaked closures are unstable in flow; a refusal must say so.
      EXPECT_TRUE(one.closure == closure_named("linear") || one.closure == closure_named("orp"))
          << one.name << failure.what();
      continue;
    }
    const Mat3 run = after_a_long_run(model, simple_shear_gradient(), 60 / steady.decay_rate);
    EXPECT_LT((steady.second - run).norm(), run_tolerance) << one.name;
  }
}

/// Retardations change how fast a state is reached, not which: the value that a run with kappa = 0.01 must
/// come to.
TEST(SteadyOrientation, RetardationOnlySlowsTheApproach) {
  OrientationModel model =
      model_with(rotary_diffusion_named("folgar_tucker"), retardation_named("none"), closure_named("ibof"));
  model.constants.c_i = 0.0311;
  Mat3 gradient = Mat3::Zero();
  gradient(0, 1) = 1;
  const SteadyOrientation plain = steady_orientation(model, gradient);
  EXPECT_NEAR(plain.second(0, 0), 0.6493761451, 1e-10);
  EXPECT_NEAR(plain.second(1, 1), 0.1312225654, 1e-10);
  EXPECT_NEAR(plain.second(2, 2), 0.2194012895, 1e-10);
  EXPECT_NEAR(plain.second(0, 1), 0.1133462673, 1e-10);
  model.retardation = retardation_named("rsc");
  model.constants.kappa = 0.01;
  const SteadyOrientation slow = steady_orientation(model, gradient);
  EXPECT_LT((slow.second - plain.second).norm(), 1e-13);
  EXPECT_LT(slow.decay_rate, 0.05 * plain.decay_rate);
}

/// The decay rate is that of a small disturbance in a run.
TEST(SteadyOrientation, DisturbancesDieOutAtTheRateThatIsTold) {
  const OrientationModel model =
      model_with(rotary_diffusion_named("folgar_tucker"), retardation_named("rsc"), closure_named("ibof"));
  const SteadyOrientation steady = steady_orientation(model, simple_shear_gradient());
  OrientationIntegrator integrator(OrientationLaw(model), FlowHistory::constant({simple_shear_gradient()}),
                                   {}, {.absolute = 1e-13, .relative = 1e-13});
  // Late enough that only the slowest disturbance is left, early enough that it is above the tolerance.
  integrator.advance_to(12 / steady.decay_rate);
  const double first = (integrator.state().second - steady.second).norm();
  integrator.advance_to(15 / steady.decay_rate);
  const double second = (integrator.state().second - steady.second).norm();
  EXPECT_NEAR(std::log(first / second) / 3, 1, 0.02);
}

std::string failure_of(const OrientationModel& model, const Mat3& gradient) {
  try {
    static_cast<void>(steady_orientation(model, gradient));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

/// IBOF has a stable state in shear without diffusion, which no fibers have: they align for ever.
TEST(SteadyOrientation, WithoutDiffusionIsOnlyWhereAFlowAligns) {
  OrientationModel model =
      model_with(rotary_diffusion_named("jeffery"), retardation_named("none"), closure_named("ibof"));
  model.constants.xi = 1;
  EXPECT_NE(failure_of(model, simple_shear_gradient()).find("stands by the error of the closure ibof"),
            std::string::npos)
      << failure_of(model, simple_shear_gradient());
  model.closure = closure_named("quadratic");  // exact for aligned fibers
  EXPECT_NEAR(steady_orientation(model, uniaxial_elongation_gradient()).second(0, 0), 1, 1e-6);
}

TEST(SteadyOrientation, IsRefusedInWordsWhereThereIsNone) {
  OrientationModel model =
      model_with(rotary_diffusion_named("folgar_tucker"), retardation_named("rsc"), closure_named("ibof"));
  EXPECT_NE(failure_of(model, Mat3::Zero()).find("nothing deforms"), std::string::npos);
  Mat3 spin = Mat3::Zero();
  spin(0, 1) = 1, spin(1, 0) = -1;
  EXPECT_NE(failure_of(model, spin).find("nothing deforms"), std::string::npos);
  model.constants.kappa = 0;
  EXPECT_NE(failure_of(model, simple_shear_gradient()).find("holds the principal values"), std::string::npos);
  const OrientationModel jeffery =
      model_with(rotary_diffusion_named("jeffery"), retardation_named("none"), closure_named("hybrid"));
  EXPECT_NE(failure_of(jeffery, simple_shear_gradient()).find("no steady orientation"), std::string::npos)
      << failure_of(jeffery, simple_shear_gradient());
  const OrientationModel linear =
      model_with(rotary_diffusion_named("folgar_tucker"), retardation_named("none"), closure_named("linear"));
  EXPECT_NE(failure_of(linear, uniaxial_elongation_gradient()).find("steady orientation"), std::string::npos)
      << failure_of(linear, uniaxial_elongation_gradient());
}

}  // namespace
}  // namespace fiberfate
