// Strong retardation from an isotropic start: principal values part slowly, the axes turn at once.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <vector>

#include "continuum/orientation_history.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/principal_axes_steps.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/eigenframe.hpp"

namespace fiberfate {
namespace {

Mat3 shear() {
  Mat3 gradient = Mat3::Zero();
  gradient(0, 1) = 1;
  return gradient;
}

OrientationModel retarded(Retardation retardation, double left) {
  OrientationModel model{rotary_diffusion_named("folgar_tucker"), retardation, closure_named("ibof"), {}};
  model.constants.c_i = 0.0311;
  if (retardation == retardation_named("rsc")) model.constants.kappa = left;
  if (retardation == retardation_named("rpr")) model.constants.alpha = 1 - left;
  return model;
}

/// Steady state of Folgar and Tucker's law with IBOF, C_I = 0.0311, shear along y, from an independent
/// computation. A run to 200/kappa is off by the tolerance of its last steps.
TEST(SlowRetardation, ReachesTheSteadyStateThatItDoesNotMove) {
  for (const Retardation retardation : {retardation_named("rsc"), retardation_named("rpr")}) {
    for (const double left : {0.1, 0.01, 1e-3}) {
      OrientationIntegrator integrator(OrientationLaw(retarded(retardation, left)),
                                       FlowHistory::constant({shear()}), {}, {1e-10, 1e-10});
      integrator.advance_to(200 / left);
      const Mat3& a = integrator.state().second;
      EXPECT_NEAR(a(0, 0), 0.6493761451, 1e-9) << left;
      EXPECT_NEAR(a(1, 1), 0.1312225654, 1e-9) << left;
      EXPECT_NEAR(a(2, 2), 0.2194012895, 1e-9) << left;
      EXPECT_NEAR(a(0, 1), 0.1133462673, 1e-9) << left;
      // The law needs less than a step in two units of strain; a million were not enough for the first one
      // before.
      EXPECT_LT(static_cast<double>(integrator.record().accepted), 100 / left) << left;
    }
  }
}

/// Both ways of stepping are right where both can go: a mild retardation, from a state with distinct values.
TEST(SlowRetardation, StepsAlongTheAxesAgreeWithExplicitOnes) {
  Mat3 start;
  start << 0.5, 0.05, 0.02, 0.05, 0.3, -0.03, 0.02, -0.03, 0.2;
  OrientationModel tuned = retarded(retardation_named("rpr"), 0.3);
  tuned.constants.beta = 0.01;
  for (const OrientationModel& model :
       {retarded(retardation_named("rsc"), 0.3), retarded(retardation_named("rpr"), 0.3), tuned}) {
    OrientationIntegrator integrator(OrientationLaw(model), FlowHistory::constant({shear()}), {0, start},
                                     {1e-12, 1e-12});
    integrator.advance_to(7);
    Mat3 state = start;
    PrincipalAxesSteps steps(model, shear(), 1e-10);
    ASSERT_TRUE(steps.advance(state, 7, 10000));
    EXPECT_LT((state - integrator.state().second).norm(),
              1e-8);  // some twenty steps of 1e-10 each, amplified
  }
}

/// The error falls with the tolerance, from an isotropic start, too: the scheme has no threshold to trip
/// over.
TEST(SlowRetardation, ConvergesFromAnIsotropicStart) {
  const OrientationModel model = retarded(retardation_named("rsc"), 0.01);
  const auto after = [&](double tolerance) {
    Mat3 state = Mat3::Identity() / 3;
    PrincipalAxesSteps steps(model, shear(), tolerance);
    EXPECT_TRUE(steps.advance(state, 100, 100000));
    return state;
  };
  const Mat3 fine = after(1e-12);
  EXPECT_LT((after(1e-6) - fine).norm(), 1e-5);
  EXPECT_LT((after(1e-9) - fine).norm(), 1e-7);
}

/// While the values are still nearly equal, they leave 1/3 as kappa t times the rate of the isotropic state,
/// and the axes are those of D, turned by what the vorticity does in the time in which they follow: kappa
/// t/(1 + kappa)·W.
TEST(SlowRetardation, LeavesTheIsotropicStateAlongTheRateOfStrain) {
  const OrientationModel model = retarded(retardation_named("rsc"), 1e-3);
  const double duration = 0.5;
  OrientationIntegrator integrator(OrientationLaw(model), FlowHistory::constant({shear()}), {},
                                   {1e-10, 1e-10});
  integrator.advance_to(duration);
  const Mat3 isotropic = Mat3::Identity() / 3;
  const Mat3 rate = OrientationLaw(unretarded(model)).rate(isotropic, shear());
  const Mat3 first_order = isotropic + 1e-3 * duration * rate;
  // Second order in kappa t: (5e-4)², times the vorticity's and the closure's factors of order one.
  EXPECT_LT((integrator.state().second - first_order).norm(), 1e-6);
}

/// Batches, as solvers for molds call them, with the default tolerance.
TEST(SlowRetardation, BatchesGetThroughFromIsotropicPoints) {
  constexpr std::size_t count = 11;
  const OrientationModel model = retarded(retardation_named("rpr"), 0.01);
  std::vector<double> second(6 * count, 0.0), gradient(9 * count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t m = 0; m < 3; ++m) second[6 * i + m] = 1.0 / 3;
    gradient[9 * i + 1] = 1 + static_cast<double>(i);
  }
  OrientationPoints points;
  points.count = count;
  points.second_stride = points.result_stride = 6;
  points.gradient_stride = 9;
  for (std::size_t m = 0; m < 6; ++m) points.second[m] = points.result[m] = &second[m];
  for (std::size_t m = 0; m < 9; ++m) points.gradient[m] = &gradient[m];
  OrientationLaw(model).advance(points, {.duration = 10, .tolerance = 1e-8});
  for (std::size_t i = 0; i < count; ++i) {
    OrientationIntegrator integrator(OrientationLaw(model),
                                     FlowHistory::constant({(1 + static_cast<double>(i)) * shear()}), {},
                                     {1e-11, 1e-11});
    integrator.advance_to(10);
    EXPECT_NEAR(second[6 * i], integrator.state().second(0, 0), 1e-5) << i;
    EXPECT_NEAR(second[6 * i + 5], integrator.state().second(0, 1), 1e-5) << i;
  }
}

}  // namespace
}  // namespace fiberfate
