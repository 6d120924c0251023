// Tests that no law takes numbers which mean nothing: one bad point is named, and its neighbours are not
// touched.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "continuum/anisotropic_stress.hpp"
#include "continuum/attrition_law.hpp"
#include "continuum/couette_rheometer.hpp"
#include "continuum/fokker_planck.hpp"
#include "continuum/homogenisation.hpp"
#include "continuum/length_registry.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_jeffery.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/stress_induced.hpp"
#include "continuum/viscosity.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/flow_history.hpp"

namespace fiberfate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const double nan_value = std::nan("");

/// What an InputError says; "" when there is none.
std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Twenty isotropic points in shear.
struct Batch {
  static constexpr std::size_t count = 20;
  std::vector<double> second = std::vector<double>(6 * count, 0.0),
                      gradient = std::vector<double>(9 * count, 0.0),
                      result = std::vector<double>(6 * count, -7.0);
  Batch() {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t m = 0; m < 3; ++m) second[6 * i + m] = 1.0 / 3;
      gradient[9 * i + 1] = 1;
    }
  }
  [[nodiscard]] OrientationPoints points(double* results) const {
    OrientationPoints view;
    view.count = count;
    view.second_stride = view.result_stride = 6;
    view.gradient_stride = 9;
    for (std::size_t m = 0; m < 6; ++m) {
      view.second[m] = &second[m];
      view.result[m] = results + m;
    }
    for (std::size_t m = 0; m < 9; ++m) view.gradient[m] = &gradient[m];
    return view;
  }
};

OrientationLaw some_law() {
  OrientationModel model = orientation_model_named("folgar_tucker", "ibof");
  model.constants.c_i = 0.01;
  return OrientationLaw(model);
}

TEST(ImpossibleInput, OneBadPointOfABatchIsNamedAndNothingIsChanged) {
  const OrientationLaw law = some_law();
  for (const double bad : {nan_value, infinity, 4.0, -0.3}) {
    Batch batch;
    batch.second[6 * 11 + 1] = bad;
    const std::vector<double> before = batch.result;
    const std::string words =
        refusal([&] { law.advance(batch.points(batch.result.data()), {.duration = 1, .tolerance = 1e-6}); });
    EXPECT_NE(words.find("orientation tensor of point 11"), std::string::npos) << bad << ": " << words;
    EXPECT_EQ(batch.result, before);
    EXPECT_NE(refusal([&] { law.evaluate(batch.points(batch.result.data())); }).find("point 11"),
              std::string::npos);
  }
  for (const double bad : {nan_value, infinity, -infinity, 1e200}) {
    Batch batch;
    batch.gradient[9 * 3 + 5] = bad;
    const std::string words =
        refusal([&] { law.advance(batch.points(batch.result.data()), {.duration = 1, .tolerance = 1e-6}); });
    EXPECT_NE(words.find("velocity gradient of point 3"), std::string::npos) << bad << ": " << words;
  }
}

TEST(ImpossibleInput, StatesThatAreSlightlyOffArePutBackAndCounted) {
  const OrientationLaw law = some_law();
  Batch batch;
  EXPECT_EQ(law.advance(batch.points(batch.result.data()), {.duration = 1, .tolerance = 1e-6}).put_back, 0U);
  const std::vector<double> sound = batch.result;
  batch.second[6 * 4] += 5e-4;   // what single precision and interpolation do
  batch.second[6 * 19] += 5e-4;  // the last point fills the last lanes alone: it counts once
  EXPECT_EQ(law.advance(batch.points(batch.result.data()), {.duration = 1, .tolerance = 1e-6}).put_back, 2U);
  EXPECT_NEAR(batch.result[24] + batch.result[25] + batch.result[26], 1, 1e-14);
  // A neighbour changes the length of steps, and by that a point by less than the tolerance.
  EXPECT_NEAR(batch.result[30], sound[30], 1e-6);
}

TEST(ImpossibleInput, PointsThatNeedTooManyStepsAreNamed) {
  const OrientationLaw law = some_law();
  Batch batch;
  batch.gradient[9 * 13 + 1] = 1e9;
  try {
    law.advance(batch.points(batch.result.data()), {.duration = 1, .tolerance = 1e-6, .most_steps = 1000});
    FAIL();
  } catch (const SimulationFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("point 13"), std::string::npos) << failure.what();
  }
}

TEST(ImpossibleInput, NoClosureTakesAWrongTrace) {
  for (const ClosureDescription& one : closures()) {
    for (const Vec3& values :
         {Vec3(2, 1, 1), Vec3(1, 0.5, 0.5), Vec3(0.7, 0.7, -0.4), Vec3(nan_value, 0, 0)}) {
      const Mat3 second = values.asDiagonal();
      EXPECT_NE(refusal([&] { static_cast<void>(close(second, one.closure)); }), "") << one.name;
      EXPECT_NE(refusal([&] { static_cast<void>(closed_double_dot(second, Mat3::Identity(), one.closure)); }),
                "")
          << one.name;
    }
    Mat3 skew = Mat3::Identity() / 3;
    skew(0, 1) = 0.1;
    EXPECT_NE(refusal([&] { static_cast<void>(close(skew, one.closure)); }), "") << one.name;
  }
}

/// Every number of a flow that breaks fibers, replaced by what no flow has.
TEST(ImpossibleInput, LengthLawsNameTheFlowThatIsImpossible) {
  for (const AttritionLawEntry& entry : attrition_laws()) {
    std::vector<double> values;
    for (const LawParameter& parameter : entry.parameters)
      values.push_back(std::isnan(parameter.standard_value) ? 0.5 : parameter.standard_value);
    if (entry.name == "phelps" || entry.name == "durin") values[1] = 3;
    const auto law = make_attrition_law(entry.name, values);
    const LengthStart start = {.initial = {{1e-3, 5e-3}, {1, 1}}};
    const auto evolution = law->start(start);
    for (const double bad : {nan_value, -1.0, infinity}) {
      for (const LengthFlow& flow : {LengthFlow{bad, 100, 1}, LengthFlow{100, bad, 1}}) {
        EXPECT_NE(refusal([&] { evolution->advance(flow, 1); }), "") << entry.name << ' ' << bad;
        EXPECT_NE(refusal([&] { static_cast<void>(law->unbreakable_length(flow)); }), "") << entry.name;
      }
      EXPECT_NE(refusal([&] { evolution->advance({100, 100, 1}, bad); }), "") << entry.name << ' ' << bad;
    }
    EXPECT_NE(refusal([&] { evolution->advance({100, 100, nan_value}, 1); }), "") << entry.name;
  }
}

TEST(ImpossibleInput, BatchesOfLengthsNameThePoint) {
  const auto law = make_attrition_law("constant", std::vector<double>{0.1, 1e-3});
  std::vector<double> rates(30, 10.0), viscosities(30, 100.0), lengths(30, 5e-3);
  rates[21] = nan_value;
  EXPECT_NE(refusal([&] {
              relax_lengths(*law->relaxation(), {rates, viscosities}, 1, lengths);
            }).find("rate[21]"),
            std::string::npos);
  EXPECT_EQ(lengths, std::vector<double>(30, 5e-3));
  rates[21] = 10;
  lengths[2] = -1;
  EXPECT_NE(refusal([&] {
              relax_lengths(*law->relaxation(), {rates, viscosities}, 1, lengths);
            }).find("lengths[2]"),
            std::string::npos);
  const PhelpsSolver solver({0.02, 3, 0.25, 73e9, 19e-6, 0, PhelpsBreakage::share}, {50, 15e-3});
  std::vector<double> numbers(30 * 50, 1.0);
  viscosities[5] = -3;
  EXPECT_NE(refusal([&] {
              solver.advance({rates, viscosities}, 1, numbers);
            }).find("viscosity[5]"),
            std::string::npos);
  viscosities[5] = 100;
  numbers[77] = nan_value;
  EXPECT_NE(refusal([&] {
              solver.advance({rates, viscosities}, 1, numbers);
            }).find("numbers[77]"),
            std::string::npos);
}

TEST(ImpossibleInput, InfiniteConstantsAreNoLaw) {
  for (const AttritionLawEntry& entry : attrition_laws()) {
    for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
      std::vector<double> values;
      for (const LawParameter& parameter : entry.parameters)
        values.push_back(std::isnan(parameter.standard_value) ? 0.5 : parameter.standard_value);
      values[i] = infinity;
      EXPECT_NE(refusal([&] { static_cast<void>(make_attrition_law(entry.name, values)); }), "")
          << entry.name << ' ' << entry.parameters[i].name;
    }
  }
  for (const ViscosityLawEntry& entry : viscosity_laws()) {
    for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
      std::vector<double> values;
      for (const LawParameter& parameter : entry.parameters)
        values.push_back(std::isnan(parameter.standard_value) ? 0.5 : parameter.standard_value);
      EXPECT_EQ(refusal([&] { static_cast<void>(make_viscosity_law(entry.name, values)); }), "");
      values[i] = infinity;
      EXPECT_NE(refusal([&] { static_cast<void>(make_viscosity_law(entry.name, values)); }), "")
          << entry.name << ' ' << entry.parameters[i].name;
    }
  }
  EXPECT_NE(refusal([] { PhelpsSolver({infinity, 3, 0.25, 73e9, 19e-6, 0}, {50, 15e-3}); }), "");
  EXPECT_NE(refusal([] { PhelpsSolver({0.02, 3, 0.25, 73e9, infinity, 0}, {50, 15e-3}); }), "");
  EXPECT_NE(refusal([] { static_cast<void>(isotropic_stiffness({infinity, 0.3})); }), "");
  EXPECT_NE(refusal([] { static_cast<void>(particle_number(infinity, 0.1)); }), "");
}

TEST(ImpossibleInput, MeltsOfImpossibleStatesAreRefused) {
  for (const ViscosityLawEntry& entry : viscosity_laws()) {
    std::vector<double> values;
    for (const LawParameter& parameter : entry.parameters)
      values.push_back(std::isnan(parameter.standard_value) ? 0.5 : parameter.standard_value);
    const auto law = make_viscosity_law(entry.name, values);
    EXPECT_GT(law->at({10, 500, 1e5}), 0) << entry.name;
    for (const MeltState& melt :
         {MeltState{nan_value, 500, 0}, MeltState{-1, 500, 0}, MeltState{infinity, 500, 0},
          MeltState{1, nan_value, 0}, MeltState{1, 500, infinity}})
      EXPECT_NE(refusal([&] { static_cast<void>(law->at(melt)); }), "") << entry.name;
  }
  const auto wlf = make_viscosity_law("cross_wlf", std::vector<double>{2e4, 0.3, 1e12, 263, 0, 28, 51.6});
  EXPECT_NE(refusal([&] { static_cast<void>(wlf->at({10, 0, 0})); }), "") << "a temperature that nobody gave";
}

TEST(ImpossibleInput, IntegrationRefusesDurationsThatAreNone) {
  using State = Eigen::Vector2d;
  State state(1, 0);
  IntegrationRecord record;
  const auto slope = [](const State& at, State& rate) { rate = -at; };
  const auto settle = [](State&) { return false; };
  for (const double bad : {-1.0, nan_value, infinity})
    EXPECT_NE(refusal([&] { integrate(slope, state, bad, {}, record, settle); }), "") << bad;
  EXPECT_EQ(state, State(1, 0));
}

TEST(ImpossibleInput, HistoriesRefuseWhatNoClockShows) {
  const FlowHistory history = FlowHistory::constant(simple_shear(10));
  EXPECT_NE(refusal([&] { static_cast<void>(history.parts(2, 1)); }), "");
  EXPECT_NE(refusal([&] { static_cast<void>(history.parts(0, nan_value)); }), "");
  EXPECT_NE(refusal([&] { FlowHistory({{0, simple_shear(infinity)}}); }), "");
  OrientationIntegrator integrator(some_law(), FlowHistory::constant({simple_shear_gradient()}), {});
  integrator.advance_to(1);
  for (const double bad : {0.5, nan_value, infinity})
    EXPECT_NE(refusal([&] { integrator.advance_to(bad); }), "") << bad;
  EXPECT_NE(refusal([&] {
              OrientationIntegrator(some_law(), FlowHistory::constant({simple_shear_gradient()}), {}, {0, 0});
            }),
            "");
}

TEST(ImpossibleInput, SingleFormulasRefuseIt) {
  const Mat3 bad = Mat3::Constant(nan_value),
             strain = 0.5 * (simple_shear_gradient() + simple_shear_gradient().transpose());
  const Mat6 fourth = close(Mat3::Identity() / 3, closure_named("linear"));
  const std::vector<std::function<void()>> calls = {
      [&] { static_cast<void>(some_law().rate(Mat3::Identity(), simple_shear_gradient())); },
      [&] { static_cast<void>(some_law().rate(Mat3::Identity() / 3, bad)); },
      [&] { static_cast<void>(anisotropic_stress(-1, 1, strain, fourth)); },
      [&] { static_cast<void>(anisotropic_stress(1, 1, bad, fourth)); },
      [&] { static_cast<void>(stretching_share(bad, fourth)); },
      [&] { static_cast<void>(fiber_deformation(bad, 1, 1)); },
      [&] { static_cast<void>(fiber_deformation(strain, 1, nan_value)); },
      [&] { static_cast<void>(jeffery_period(0, 1)); },
      [&] {
        static_cast<void>(shear_rate({1e-2, 2e-2, 1, CouetteRate::inner_wall}, nan_value));
      },
      [&] {
        static_cast<void>(shear_rate({1e-2, infinity, 1, CouetteRate::inner_wall}, 50));
      },
      [&] {
        static_cast<void>(mean_lengths(LengthClasses{{1e-3}, {0}}));
      },
      [&] {
        static_cast<void>(mean_lengths(LengthClasses{{1e-3}, {nan_value}}));
      },
      [&] {
        static_cast<void>(histogram({{1e-3}, {1}}, std::vector<double>{0, nan_value, 1}));
      },
      [&] { static_cast<void>(orientation_average(Mat6::Identity(), fourth, Mat3::Identity())); },
      [&] { static_cast<void>(FokkerPlanck({}, 10).steady(bad)); }};
  for (std::size_t i = 0; i < calls.size(); ++i) EXPECT_NE(refusal(calls[i]), "") << "call " << i;
}

}  // namespace
}  // namespace fiberfate
