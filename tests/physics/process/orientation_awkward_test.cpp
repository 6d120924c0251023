// Shows that histories from awkward states, in awkward flows, stay finite and admissible with every law.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "continuum/orientation_history.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/eigenframe.hpp"
#include "reference/awkward_states.hpp"

namespace fiberfate {
namespace {

/// Every pair of a diffusion and a retardation, with constants of the usual size; C_M = 1 makes iARD's tensor
/// indefinite in uniaxial flow.
std::vector<OrientationModel> all_models(Closure closure) {
  std::vector<OrientationModel> models;
  for (const auto& diffusion : rotary_diffusions()) {
    for (const auto& retardation : retardations()) {
      OrientationModel model{diffusion.choice, retardation.choice, closure, {}};
      for (const auto* names : {&diffusion.constants, &retardation.constants})
        for (const std::string& name : *names)
          set_constant(model, name,
                       name == "kappa" || name == "srf" ? 0.1
                       : name == "alpha"                ? 0.9
                       : name == "beta"                 ? 0.01
                       : name == "C_M"                  ? 1.0
                       : name == "Omega"                ? 0.7
                       : name[0] == 'D'                 ? 0.9 / (name[1] - '0')
                                                        : 0.01);
      models.push_back(model);
    }
  }
  return models;
}

std::string label(const OrientationModel& model) {
  return std::string(name(model.diffusion)) + "+" + name(model.retardation) + " " + name(model.closure);
}

/// Each state in each flow, the flow turned so that its axes are not those of the state.
struct Batch {
  std::vector<double> second, gradient;
  OrientationPoints points;
  Batch() {
    Mat3 spin = Mat3::Zero(), tilt;
    spin(0, 1) = 1;
    spin(1, 0) = -1;
    tilt << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
    std::vector<std::pair<Mat3, Mat3>> all;
    for (const Mat3& state : awkward_states())
      for (const Mat3& flow :
           {simple_shear_gradient(), uniaxial_elongation_gradient(), biaxial_elongation_gradient(),
            planar_elongation_gradient(), spin, Mat3(Mat3::Zero())})
        for (const Mat3& rotation : {Mat3(Mat3::Identity()), tilt})
          all.emplace_back(state, rotated(flow, rotation));
    points.count = all.size();
    second.resize(6 * points.count);
    gradient.resize(9 * points.count);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Vec6 a = to_components(all[i].first);
      for (std::size_t m = 0; m < 6; ++m) second[m * points.count + i] = a[static_cast<int>(m)];
      for (std::size_t m = 0; m < 9; ++m)
        gradient[m * points.count + i] = all[i].second(static_cast<int>(m) / 3, static_cast<int>(m) % 3);
    }
    for (std::size_t m = 0; m < 6; ++m) points.second[m] = points.result[m] = &second[m * points.count];
    for (std::size_t m = 0; m < 9; ++m) points.gradient[m] = &gradient[m * points.count];
  }
  [[nodiscard]] Mat3 state(std::size_t i) const {
    Vec6 a;
    for (std::size_t m = 0; m < 6; ++m) a[static_cast<int>(m)] = second[m * points.count + i];
    return to_matrix(a);
  }
};

TEST(AwkwardStates, EveryLawKeepsThemAdmissible) {
  for (const Closure closure :
       {closure_named("quadratic"), closure_named("hybrid"), closure_named("ibof"), closure_named("orf"),
        closure_named("orw"), closure_named("orw3"), closure_named("ore"), closure_named("bingham")}) {
    for (const OrientationModel& model : all_models(closure)) {
      Batch batch;
      OrientationLaw(model).advance(batch.points, {.duration = 5, .tolerance = 1e-6});
      for (std::size_t i = 0; i < batch.points.count; ++i) {
        const Mat3 state = batch.state(i);
        ASSERT_TRUE(state.allFinite()) << label(model) << ", point " << i;
        EXPECT_LT(std::abs(state.trace() - 1), 1e-14) << label(model) << ", point " << i;
        EXPECT_GT(eigenframe(state).values[2], -1e-14) << label(model) << ", point " << i;
      }
    }
  }
}

/// An isotropic start has no axes of its own: with RSC or RPR it follows those of D, so that a flow turned
/// together with its axes gives the turned history, however the computation's frame lies.
TEST(AwkwardStates, IsotropicStartsAreObjective) {
  Mat3 tilt;
  tilt << 0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6;
  for (const OrientationModel& model : all_models(closure_named("ibof"))) {
    if (model.retardation == retardation_named("srf")) continue;
    const auto after = [&](const Mat3& gradient) {
      OrientationIntegrator integrator(OrientationLaw(model), FlowHistory::constant({gradient}), {},
                                       {.absolute = 1e-10, .relative = 1e-10});
      integrator.advance_to(3);
      return integrator.state().second;
    };
    const Mat3 turned = after(rotated(simple_shear_gradient(), tilt));
    EXPECT_LT((turned - rotated(after(simple_shear_gradient()), tilt)).norm(), 1e-8) << label(model);
  }
}

/// Twice the rate, half the time: the history is one of strain.
TEST(AwkwardStates, HistoriesScaleWithTheRate) {
  for (OrientationModel model : all_models(closure_named("ore"))) {
    model.constants.beta = 0;  // the one constant with a dimension
    const auto after = [&](double rate, double time) {
      OrientationIntegrator integrator(OrientationLaw(model),
                                       FlowHistory::constant({rate * simple_shear_gradient()}), {},
                                       {.absolute = 1e-10, .relative = 1e-10});
      integrator.advance_to(time);
      return integrator.state().second;
    };
    EXPECT_LT((after(2, 1.5) - after(1, 3)).norm(), 1e-12) << label(model);
  }
}

/// r to infinity: the history of ever longer fibers tends to that of slender ones, as 2/r².
TEST(AwkwardStates, LongFibersTendToSlenderOnes) {
  const auto a11 = [](double aspect_ratio) {
    OrientationModel model{
        rotary_diffusion_named("folgar_tucker"), retardation_named("rsc"), closure_named("ibof"), {}};
    model.constants.c_i = 0.005;
    model.constants.kappa = 0.3;
    model.constants.xi = shape_factor(aspect_ratio);
    OrientationIntegrator integrator(OrientationLaw(model), FlowHistory::constant({simple_shear_gradient()}),
                                     {}, {.absolute = 1e-12, .relative = 1e-12});
    integrator.advance_to(20);
    return integrator.state().second(0, 0);
  };
  const double slender = a11(std::numeric_limits<double>::infinity());
  const double far = a11(100) - slender, farther = a11(1000) - slender;
  EXPECT_NEAR(farther / far, 0.01, 1e-3);
  EXPECT_EQ(a11(1e200), slender);
}

}  // namespace
}  // namespace fiberfate
