// Shows that histories are followed accurately: batches, intervals, long runs, known steady states.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_jeffery.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/eigenframe.hpp"

namespace fiberfate {
namespace {

OrientationModel folgar_tucker(double c_i, Closure closure) {
  OrientationModel model{rotary_diffusion_named("folgar_tucker"), retardation_named("none"), closure, {}};
  model.constants.c_i = c_i;
  return model;
}

OrientationModel iard_rpr() {
  OrientationModel model{rotary_diffusion_named("iard"), retardation_named("rpr"), closure_named("ibof"), {}};
  model.constants.c_i = 0.0165;
  model.constants.c_m = 0.999;
  model.constants.alpha = 0.965;
  return model;
}

TEST(OrientationHistory, TraceStaysOneThroughAThousandUnitsOfStrain) {
  OrientationIntegrator integrator(OrientationLaw(iard_rpr()),
                                   FlowHistory::constant({simple_shear_gradient()}), {});
  integrator.advance_to(1000);
  EXPECT_NEAR(integrator.state().second.trace(), 1, 1e-14);
  EXPECT_EQ(fault_of(integrator.state().second), "");
  EXPECT_GT(integrator.record().accepted, 20);
}

TEST(OrientationHistory, AFlowThatReversesLeadsBackWithoutDiffusion) {
  // Jeffery's motion is reversible: F after the reversal is the identity.
  OrientationModel model;
  model.closure = closure_named("exact");
  const FlowHistory history({{0, {simple_shear_gradient()}}, {2, {-simple_shear_gradient()}}});
  OrientationIntegrator integrator(OrientationLaw(model), history, {},
                                   {.absolute = 1e-11, .relative = 1e-11});
  integrator.advance_to(4);
  EXPECT_LT((integrator.state().second - Mat3(Mat3::Identity() / 3)).norm(), 1e-9);
}

TEST(OrientationHistory, ChangesOfFlowAreMetExactly) {
  OrientationModel model;
  model.closure = closure_named("exact");
  const FlowHistory history({{0, {simple_shear_gradient()}}, {0.7, {uniaxial_elongation_gradient()}}});
  OrientationIntegrator integrator(OrientationLaw(model), history, {},
                                   {.absolute = 1e-11, .relative = 1e-11});
  integrator.advance_to(1.9);
  const Mat3 deformation = fiber_deformation(uniaxial_elongation_gradient(), 1, 1.2) *
                           fiber_deformation(simple_shear_gradient(), 1, 0.7);
  EXPECT_LT((integrator.state().second - carried_isotropic_state(deformation)).norm(), 1e-9);
}

TEST(OrientationHistory, InterpolatedGradientsConverge) {
  // D(t) = t E: the same as E for t²/2, since E commutes with itself.
  const FlowHistory ramp({{0, {}}, {1, {planar_elongation_gradient()}}}, HistoryForm::ramps);
  OrientationModel model;
  model.closure = closure_named("exact");
  OrientationIntegrator integrator(OrientationLaw(model), ramp.in_steps(8), {},
                                   {.absolute = 1e-11, .relative = 1e-11});
  integrator.advance_to(1);
  EXPECT_LT((integrator.state().second -
             carried_isotropic_state(fiber_deformation(planar_elongation_gradient(), 1, 0.5)))
                .norm(),
            1e-9);
}

double steady_a11(Closure closure) {
  const OrientationLaw law(folgar_tucker(0.01, closure));
  OrientationIntegrator integrator(law, FlowHistory::constant({simple_shear_gradient()}), {});
  integrator.advance_to(300);
  EXPECT_LT(law.rate(integrator.state().second, simple_shear_gradient()).norm(), 1e-7);
  return integrator.state().second(0, 0);
}

TEST(OrientationHistory, FittedClosuresEndWhereTheExactOneDoes) {
  // At C_I = 0.01 the truth is A11 = 0.7271243 (orientation_distribution_test). The closure that is exact
  // without diffusion ends 0.046 above; fits to it and to a wide range of C_I cannot but follow. The hybrid
  // one is 0.16 off.
  const double exact = steady_a11(closure_named("exact"));
  EXPECT_NEAR(exact, 0.7733, 1e-4);
  for (const Closure closure :
       {closure_named("ibof"), closure_named("ore"), closure_named("orw"), closure_named("orw3")})
    EXPECT_NEAR(steady_a11(closure), exact, 0.005) << name(closure);
  EXPECT_NEAR(steady_a11(closure_named("orf")), 0.7271243, 0.03);
  EXPECT_GT(steady_a11(closure_named("hybrid")), 0.7271243 + 0.15);
}

TEST(OrientationHistory, BatchesAgreeWithSinglePoints) {
  constexpr std::size_t count = 1003;  // neither a multiple of eight nor of a thread's share
  std::vector<double> states(6 * count), gradients(9 * count), rates(6 * count), advanced(6 * count);
  OrientationPoints points;
  points.count = count;
  for (std::size_t m = 0; m < 6; ++m) points.second[m] = &states[m * count];
  for (std::size_t m = 0; m < 6; ++m) points.result[m] = &rates[m * count];
  for (std::size_t m = 0; m < 9; ++m) points.gradient[m] = &gradients[m * count];
  const auto state_of = [](std::size_t i) {
    const double x = static_cast<double>(i) / count;
    return Mat3(Vec3(0.4 + 0.4 * x, 0.35 - 0.2 * x, 0.25 - 0.2 * x).asDiagonal());
  };
  const auto gradient_of = [](std::size_t i) {
    const double x = static_cast<double>(i) / count;
    return Mat3(simple_shear_gradient() * (1 + x) + x * planar_elongation_gradient());
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec6 a = to_components(state_of(i));
    for (std::size_t m = 0; m < 6; ++m) states[m * count + i] = a[static_cast<int>(m)];
    for (std::size_t m = 0; m < 9; ++m)
      gradients[m * count + i] = gradient_of(i)(static_cast<int>(m) / 3, static_cast<int>(m) % 3);
  }
  const OrientationLaw law(iard_rpr());
  law.evaluate(points);
  for (std::size_t m = 0; m < 6; ++m) points.result[m] = &advanced[m * count];
  law.advance(points, {.duration = 2, .tolerance = 1e-9});
  for (const std::size_t i : {std::size_t{0}, std::size_t{7}, std::size_t{500}, count - 1}) {
    const Vec6 rate = to_components(law.rate(state_of(i), gradient_of(i)));
    OrientationIntegrator integrator(law, FlowHistory::constant({gradient_of(i)}), {0, state_of(i)},
                                     {.absolute = 1e-12, .relative = 1e-12});
    integrator.advance_to(2);
    const Vec6 after = to_components(integrator.state().second);
    for (std::size_t m = 0; m < 6; ++m) {
      EXPECT_EQ(rates[m * count + i], rate[static_cast<int>(m)]);
      EXPECT_NEAR(advanced[m * count + i], after[static_cast<int>(m)],
                  1e-6);  // 1e-9 a step, hundreds of steps
    }
  }
  const std::vector<double> on_all = advanced;
  const int threads = thread_count();
  use_threads(1);
  law.advance(points, {.duration = 2, .tolerance = 1e-9});
  use_threads(threads);
  EXPECT_EQ(on_all, advanced);  // bit for bit on any number of threads
}

TEST(OrientationHistory, ImpossibleStartsAndHistoriesAreRefused) {
  const OrientationLaw law(iard_rpr());
  const FlowHistory shear = FlowHistory::constant({simple_shear_gradient()});
  EXPECT_THROW(OrientationIntegrator(law, shear, {0, Mat3(Vec3(0.7, 0.5, -0.2).asDiagonal())}), InputError);
  EXPECT_THROW(OrientationIntegrator(law, shear, {0, Mat3::Identity()}), InputError);
  const FlowHistory ramp({{0, {}}, {1, {simple_shear_gradient()}}}, HistoryForm::ramps);
  EXPECT_THROW(OrientationIntegrator(law, ramp, {}), InputError);
}

}  // namespace
}  // namespace fiberfate
