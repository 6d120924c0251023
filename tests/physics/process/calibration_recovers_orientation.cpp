// Calibrates orientation laws to synthetic measurements of themselves, and counts how often the truth is in
// the interval.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "calibration/fit.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_registry.hpp"

namespace fiberfate {
namespace {

constexpr double noise = 0.01;  // of every component of A2, as good measurements have
constexpr std::uint64_t seed = 1;

struct Constant {
  const char* name;
  double truth;
};

struct Case {
  const char* law;
  std::vector<Constant> constants;
};

/// a11, a33 and a13 at six times, in shear and in planar elongation of rate 1/s.
void predict(const OrientationModel& model, std::span<double> components) {
  const OrientationLaw law(model);
  std::size_t i = 0;
  for (const Mat3& gradient : {simple_shear_gradient(), planar_elongation_gradient()}) {
    Mat3 start = Vec3(0.36, 0.33, 0.31).asDiagonal();
    OrientationIntegrator integrator(law, GradientHistory::constant(gradient), {0, start}, {1e-9, 1e-9});
    for (const double time : {1.0, 2.0, 4.0, 7.0, 12.0, 20.0}) {
      integrator.advance_to(time);
      const Mat3& second = integrator.state().second;
      components[i++] = second(0, 0);
      components[i++] = second(2, 2);
      components[i++] = second(0, 2);
    }
  }
}

OrientationModel model_with(const Case& one, std::span<const double> values) {
  OrientationModel model = orientation_model_named(one.law, "ibof");
  for (std::size_t i = 0; i < values.size(); ++i) set_constant(model, one.constants[i].name, values[i]);
  return model;
}

FitProblem pose(const Case& one, std::uint32_t repetition) {
  FitProblem problem;
  std::vector<double> truth;
  for (const Constant& constant : one.constants) {
    truth.push_back(constant.truth);
    problem.parameters.push_back({constant.name, "1", 0.8 * constant.truth, 0, 1e3, ParameterScale::linear});
  }
  problem.model = [one](std::span<const double> values, std::span<double> components) {
    predict(model_with(one, values), components);
  };
  FitSeries series = {"components", "1", std::vector<double>(36), std::vector<double>(36, noise)};
  predict(model_with(one, truth), series.observed);
  for (std::uint32_t i = 0; i < 36; ++i)
    series.observed[i] += noise * normal2(seed, RandomStream::noise, {repetition, i})[0];
  problem.series.push_back(series);
  return problem;
}

class EveryOrientationLaw : public testing::TestWithParam<Case> {};

TEST_P(EveryOrientationLaw, HoldsTheTruthIn95Of100) {
  const Case& one = GetParam();
  std::vector<int> held(one.constants.size(), 0);
  for (std::uint32_t repetition = 0; repetition < 100; ++repetition) {
    const FitResult result = fit(pose(one, repetition));
    for (std::size_t k = 0; k < held.size(); ++k) {
      EXPECT_EQ(result.parameters[k].outcome, ParameterOutcome::determined) << one.law << ", " << repetition;
      const ConfidenceInterval interval = result.parameters[k].interval;
      held[k] += interval.lower <= one.constants[k].truth && one.constants[k].truth <= interval.upper ? 1 : 0;
    }
  }
  for (std::size_t k = 0; k < held.size(); ++k) {
    RecordProperty(one.constants[k].name, held[k]);
    EXPECT_NEAR(held[k], 95, 4) << one.law << ": " << one.constants[k].name;
  }
}

const std::vector<Case> cases = {
    {"folgar_tucker", {{"C_I", 0.02}}},        {"rsc", {{"C_I", 0.02}, {"kappa", 0.4}}},
    {"srf", {{"C_I", 0.02}, {"srf", 0.4}}},    {"iard_rpr", {{"C_I", 0.03}, {"C_M", 0.5}, {"alpha", 0.5}}},
    {"pard", {{"C_I", 0.03}, {"Omega", 0.6}}}, {"mrd", {{"C_I", 0.03}, {"D2", 0.6}, {"D3", 0.4}}},
    {"wpt", {{"b1", 0.01}, {"b3", 0.02}}}};

INSTANTIATE_TEST_SUITE_P(SyntheticCalibration, EveryOrientationLaw, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.law); });

}  // namespace
}  // namespace fiberfate
