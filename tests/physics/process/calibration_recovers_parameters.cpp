// Calibrates every attrition law to synthetic measurements of itself, and counts how often the truth is in
// the interval.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/random.hpp"
#include "calibration/fit.hpp"
#include "continuum/length_prediction.hpp"
#include "continuum/length_registry.hpp"

namespace fiberfate {
namespace {

/// An experiment: a Couette run at one speed, L_N and L_W measured at several times with 2 % noise.
struct Run {
  LengthHistory history;
  std::vector<double> times;
};

struct Case {
  std::string law;
  std::vector<double> truth;          ///< of all parameters
  std::vector<std::string> searched;  ///< names of the free ones
};

constexpr double noise = 0.02;
// Of twelve seeds tried for the four cheap laws, ten hold all counts within 4; the test of 1000 is the strict
// one.
constexpr std::uint64_t seed = 2;

/// Rates and times that reach both the decay and the final length: where one is not observed, no interval is
/// right.
const std::vector<Run>& runs() {
  static const std::vector<Run> all = {{LengthHistory::constant({20, 0, 0}), {5, 10, 20, 40, 80, 150}},
                                       {LengthHistory::constant({40, 0, 0}), {2, 5, 10, 20, 40, 80}},
                                       {LengthHistory::constant({80, 0, 0}), {1, 2, 5, 10, 20, 40}}};
  return all;
}

/// Thin enough that L_ub, 1.6 to 2.1 mm, spans several bins: where it spans one or two, the lengths that
/// Phelps predicts are a staircase over zeta, with local minima on its steps.
const ViscosityLaw& melt() {
  static const auto law = make_viscosity_law("power_law", std::vector<double>{134, 0.73, 1e-3});
  return *law;
}

LengthStart pellets() {
  return {{{10e-3}, {1}}, {}, LengthForm::distribution, ClassWeight::length, {40, 10e-3}};
}

void predict(const std::string& name, std::span<const double> parameters, std::span<double> lengths) {
  const auto law = make_attrition_law(name, parameters);
  std::size_t i = 0;
  // Relaxation laws keep one class, for which L_N and L_W are one number; Phelps tells them apart.
  for (const Run& run : runs())
    follow_lengths(*law, pellets(), {run.history, melt()}, run.times, [&](const LengthSample& sample) {
      lengths[i++] = sample.evolution.means().number_average;
      lengths[i++] = sample.evolution.means().weight_average;
    });
}

FitProblem pose(const Case& one, std::uint32_t repetition) {
  const AttritionLawEntry& entry = find_attrition_law(one.law);
  FitProblem problem;
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    const LawParameter& parameter = entry.parameters[i];
    const bool searched =
        std::find(one.searched.begin(), one.searched.end(), parameter.name) != one.searched.end();
    // Starting off the truth, less so for an exponent of a ratio of a million: L_inf must stay below the
    // fibers' length, or nothing breaks and no direction leads anywhere.
    const double start = !searched ? 1.0 : parameter.name == "alpha" ? 1.02 : 1.2;
    problem.parameters.push_back({parameter.name, parameter.unit, one.truth[i] * start, parameter.lower,
                                  parameter.upper, ParameterScale::logarithmic,
                                  searched ? ParameterRole::free : ParameterRole::fixed});
  }
  problem.model = [name = one.law](std::span<const double> parameters, std::span<double> lengths) {
    predict(name, parameters, lengths);
  };
  std::size_t count = 0;
  for (const Run& run : runs()) count += 2 * run.times.size();
  FitSeries series = {"lengths", "m", std::vector<double>(count), {}};
  predict(one.law, one.truth, series.observed);
  for (double& length : series.observed) {
    series.uncertainty.push_back(noise * length);
    const auto i = static_cast<std::uint32_t>(series.uncertainty.size());
    length += noise * length * normal2(seed, RandomStream::noise, {repetition, i})[0];
  }
  problem.series.push_back(series);
  return problem;
}

/// Counts, by searched parameter, the repetitions whose 95 % interval holds the truth.
std::vector<int> count_held(const Case& one, std::uint32_t repetitions) {
  std::vector<int> held(one.searched.size(), 0);
  for (std::uint32_t repetition = 0; repetition < repetitions; ++repetition) {
    const FitProblem problem = pose(one, repetition);
    const FitResult result = fit(problem);
    EXPECT_TRUE(result.converged) << one.law << ", repetition " << repetition;
    const std::vector<std::size_t> searched = problem.free_parameters();
    for (std::size_t k = 0; k < searched.size(); ++k) {
      EXPECT_EQ(result.parameters[searched[k]].outcome, ParameterOutcome::determined) << one.law;
      const ConfidenceInterval interval = result.parameters[searched[k]].interval;
      held[k] += interval.lower <= one.truth[searched[k]] && one.truth[searched[k]] <= interval.upper ? 1 : 0;
    }
  }
  return held;
}

class EveryLaw : public testing::TestWithParam<Case> {};

TEST_P(EveryLaw, HoldsTheTruthIn95Of100) {
  const std::vector<int> held = count_held(GetParam(), 100);
  for (std::size_t k = 0; k < held.size(); ++k) {
    EXPECT_NEAR(held[k], 95, 4) << GetParam().law << ": " << GetParam().searched[k];
    RecordProperty(GetParam().searched[k], held[k]);
  }
}

const std::vector<Case> cases = {
    {"constant", {0.04, 1.1e-3}, {"k_f", "L_inf"}},
    {"unbreakable_length", {0.06, 1.5e-3, 2e9, 19e-6}, {"lambda", "xi"}},
    {"rate_power", {1e-4, 1.0, 2.4e-3, 0.84, 2e9, 19e-6}, {"lambda", "alpha", "xi", "beta"}},
    {"stress_induced", {4e-5, 1.05, 3e4, 0.95, 2e9, 19e-6}, {"lambda", "alpha", "k_0", "beta"}},
    {"phelps", {2.5e-3, 3, 0.25, 73e9, 19e-6, 0}, {"C_B", "zeta", "S"}},
    {"durin", {2.5e-3, 3, 0.25, 73e9, 19e-6, 0}, {"C_B", "zeta", "S"}},
};

/// The same for many more repetitions of the laws that cost little: 1000 know 95 % to 0.7 %; three of those.
TEST(SyntheticCalibration, HoldsTheTruthIn95Percent) {
  for (const Case& one : cases) {
    if (find_attrition_law(one.law).make(one.truth)->relaxation() == nullptr) continue;
    const std::vector<int> held = count_held(one, 1000);
    for (std::size_t k = 0; k < held.size(); ++k)
      EXPECT_NEAR(held[k], 950, 21) << one.law << ": " << one.searched[k];
  }
}

INSTANTIATE_TEST_SUITE_P(SyntheticCalibration, EveryLaw, testing::ValuesIn(cases),
                         [](const auto& one) { return one.param.law; });

}  // namespace
}  // namespace fiberfate
