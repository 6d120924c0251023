// Tests calibration in molds against measurements that the moldings make themselves.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "base/random.hpp"
#include "calibration/fit.hpp"
#include "keys/case_file.hpp"
#include "studies/calibration/mold_experiment.hpp"
#include "studies/calibration/molds.hpp"

namespace fiberfate {
namespace {

const char* const plaque = R"(
study = "molding"
[part]
kind = "plaque"
length = "305 mm"
width = "102 mm"
thickness = "1.5 mm"
mesh_size = "20 mm"
[material]
preset = "ppgf20"
[machine]
fill_time = "1.5 s"
melt_temperature = "523.15 K"
mold_temperature = "323.15 K"
[fibers]
number_average = "1.976 mm"
weight_average = "6.745 mm"
[numerics]
layers = 8
steps = 60
[output]
places = [["Loc.1", "30 mm", "51 mm"], ["Loc.2", "150 mm", "51 mm"], ["Loc.3", "260 mm", "51 mm"]]
)";

const std::vector<double> true_values = {0.124, 2e-3, 2e9, 19e-6};  // lambda, xi, sigma_u, d_f

MoldingCase molding(const std::vector<std::string>& changes = {}) {
  static const CaseKind kind = molding_kind();
  return std::any_cast<MoldingCase>(parse_case(plaque, "plaque.toml", {&kind}, changes).values);
}

std::vector<double> flat(const std::vector<MeanLengths>& lengths) {
  std::vector<double> all;
  for (const MeanLengths& one : lengths) {
    all.push_back(one.number_average);
    all.push_back(one.weight_average);
  }
  return all;
}

TEST(MoldExperiment, FollowsLengthsAgainInsteadOfFillingAgain) {
  MoldExperiment kept(molding(), "unbreakable_length");
  std::vector<double> other = true_values;
  other[1] = 5e-3;
  (void)kept.predict(true_values);
  const std::vector<double> again = flat(kept.predict(other));
  EXPECT_EQ(kept.fillings(), 1);
  EXPECT_EQ(again, flat(MoldExperiment(molding(), "unbreakable_length").predict(other)));
}

TEST(MoldExperiment, FillsForEveryValueWhereTheFlowFeelsTheFibers) {
  MoldExperiment coupled(molding({"fibers.coupling=informed_isotropic", "fibers.trouton_term=10"}),
                         "unbreakable_length");
  EXPECT_TRUE(coupled.is_coupled());
  const std::vector<double> lengths = flat(coupled.predict(true_values));
  (void)coupled.predict(true_values);
  EXPECT_EQ(coupled.fillings(), 2);
  // Coupling flattens the shear rate at the wall, where most fibers break: they stay longer.
  const std::vector<double> uncoupled =
      flat(MoldExperiment(molding(), "unbreakable_length").predict(true_values));
  for (std::size_t i = 1; i < lengths.size(); i += 2) EXPECT_GT(lengths[i], 1.02 * uncoupled[i]);
}

TEST(MoldExperiment, TellsWhereNoMeltComes) {
  MoldExperiment weak(molding({"machine.pressure_limit=10 MPa"}), "unbreakable_length");
  try {
    (void)weak.predict(true_values);
    FAIL() << "a short shot has no length at its end";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no melt comes to \"Loc.2\""), std::string::npos)
        << error.what();
  }
}

/// Poses the fit of xi to `samples` lengths a place and mean with 5 % noise.
FitProblem noisy_problem(MoldExperiment& experiment, int samples, std::uint64_t seed) {
  FitProblem problem;
  const char* const names[] = {"lambda", "xi", "sigma_u", "d_f"};
  for (std::size_t i = 0; i < true_values.size(); ++i)
    problem.parameters.push_back({names[i], "1", true_values[i], 0, 1e12, ParameterScale::logarithmic,
                                  i == 1 ? ParameterRole::free : ParameterRole::fixed});
  problem.parameters[1].initial = 1e-3;
  const std::vector<double> lengths = flat(experiment.predict(true_values));
  for (std::uint32_t i = 0; i < lengths.size(); ++i) {
    FitSeries series = {"length", "m", {}, {}};
    double mean = 0;
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(samples); ++k) {
      const double noise = normal2(seed, RandomStream::noise, {i, k})[0];
      series.observed.push_back(lengths[i] * (1 + 0.05 * noise));
      mean += series.observed.back() / samples;
    }
    series.uncertainty.assign(series.observed.size(), 0.05 * mean);
    problem.series.push_back(std::move(series));
  }
  problem.model = [&experiment, samples](std::span<const double> parameters, std::span<double> predictions) {
    const std::vector<double> all = flat(experiment.predict(parameters));
    for (std::size_t i = 0; i < predictions.size(); ++i)
      predictions[i] = all[i / static_cast<std::size_t>(samples)];
  };
  return problem;
}

/// With s per cent of noise in n lengths the standard error of ln xi is s/sqrt(sum of squared slopes): 0.85 %
/// with 96 samples of each of six lengths. Draws then scatter by as much about the truth, without bias, and
/// 3 % are three and a half standard errors.
TEST(MoldCalibration, RecoversXiFromNoisyLengthsForAnyDraw) {
  MoldExperiment experiment(molding(), "unbreakable_length");
  constexpr int draws = 40;
  int held = 0;
  double sum = 0, squares = 0, error = 0;
  for (std::uint64_t seed = 1; seed <= draws; ++seed) {
    const FitResult result = fit(noisy_problem(experiment, 96, seed));
    const ParameterEstimate& xi = result.parameters[1];
    const double off = std::log(xi.value / 2e-3);
    EXPECT_LT(std::abs(off), 0.03) << "draw " << seed;
    error = xi.standard_error / xi.value;
    EXPECT_LT(error, 0.01);
    sum += off;
    squares += off * off;
    held += xi.interval.lower < 2e-3 && 2e-3 < xi.interval.upper ? 1 : 0;
  }
  const double deviation = std::sqrt(squares / draws);
  // The mean of the draws scatters by error/sqrt(40), their deviation by a share of 1/sqrt(80): three of
  // each.
  EXPECT_LT(std::abs(sum / draws), 3 * error / std::sqrt(draws));
  EXPECT_NEAR(deviation, error, 0.34 * error);
  EXPECT_GE(held, 34);  // 38 of 40 expected, three standard deviations less
}

}  // namespace
}  // namespace fiberfate
