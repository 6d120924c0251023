// Tests fits against certified results, closed formulas and their own statistics.
#include "calibration/fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/error.hpp"
#include "base/random.hpp"
#include "calibration/bootstrap.hpp"
#include "calibration/prediction_band.hpp"
#include "calibration/profile.hpp"
#include "calibration/student.hpp"
#include "calibration/sweep.hpp"

namespace fiberfate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

FitParameter free_parameter(const char* name, double initial, ParameterScale scale = ParameterScale::linear) {
  return {name, "1", initial, -infinity, infinity, scale, ParameterRole::free};
}

FitSeries series(std::vector<double> observed, double uncertainty = 1) {
  const std::size_t count = observed.size();
  return {"y", "1", std::move(observed), std::vector<double>(count, uncertainty)};
}

/// NIST StRD nonlinear regression, data set Misra1a: y = b1 (1 - exp(-b2 x)).
const std::vector<double> misra_x = {77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                                     378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
const std::vector<double> misra_y = {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                                     44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};

FitProblem misra1a(ParameterScale scale) {
  const FitModel model = [](std::span<const double> b, std::span<double> y) {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = -b[0] * std::expm1(-b[1] * misra_x[i]);
  };
  return {{free_parameter("b1", 500, scale), free_parameter("b2", 1e-4, scale)},
          {series(misra_y)},
          model,
          NoiseScale::estimated};
}

FitProblem straight_line(const std::vector<double>& x, const std::vector<double>& y) {
  const FitModel model = [x](std::span<const double> p, std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = p[0] + p[1] * x[i];
  };
  return {{free_parameter("intercept", 0.5), free_parameter("slope", 1)},
          {series(y)},
          model,
          NoiseScale::estimated};
}

const std::vector<double> line_x = {0, 1, 2, 3, 4, 5, 6, 7};
const std::vector<double> line_y = {1.1, 2.8, 5.3, 6.9, 9.2, 10.7, 13.4, 14.8};

TEST(StudentQuantile, AgreesWithTables) {
  EXPECT_NEAR(student_quantile(0.95, 1), 12.706204736432095, 1e-9);
  EXPECT_NEAR(student_quantile(0.95, 10), 2.2281388519649385, 1e-10);
  EXPECT_NEAR(student_quantile(0.99, 30), 2.7499956535672246, 1e-10);
  EXPECT_NEAR(student_quantile(0.95, infinity), 1.959963984540054, 1e-12);
  EXPECT_TRUE(std::isnan(student_quantile(0.95, 0)));
}

TEST(Fit, ReproducesTheCertifiedMisra1a) {
  for (const ParameterScale scale : {ParameterScale::linear, ParameterScale::logarithmic}) {
    const FitResult result = fit(misra1a(scale));
    ASSERT_TRUE(result.converged);
    EXPECT_NEAR(result.values[0], 2.3894212918e+02, 1e-6);
    EXPECT_NEAR(result.values[1], 5.5015643181e-04, 1e-12);
    EXPECT_NEAR(result.parameters[0].standard_error, 2.7070075241e+00, 1e-5);
    EXPECT_NEAR(result.parameters[1].standard_error, 7.2668688436e-06, 1e-11);
    EXPECT_NEAR(result.noise_scale, 1.0187876330e-01, 1e-9);
    EXPECT_NEAR(result.chi_square, 1.2455138894e-01, 1e-9);
    EXPECT_EQ(result.degrees_of_freedom, 12);
  }
}

TEST(Fit, EqualsTheNormalEquationsOfALine) {
  const FitResult result = fit(straight_line(line_x, line_y));
  Eigen::MatrixXd design(8, 2);
  for (int i = 0; i < 8; ++i) design.row(i) << 1, line_x[static_cast<std::size_t>(i)];
  const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(line_y.data(), 8);
  const Eigen::MatrixXd inverse = (design.transpose() * design).inverse();
  const Eigen::VectorXd exact = inverse * design.transpose() * y;
  const double variance = (y - design * exact).squaredNorm() / 6;
  for (int i = 0; i < 2; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_NEAR(result.values[at], exact[i], 1e-10);
    const double error = std::sqrt(variance * inverse(i, i));
    EXPECT_NEAR(result.parameters[at].standard_error, error, 1e-8);
    EXPECT_NEAR(result.parameters[at].interval.upper - exact[i], student_quantile(0.95, 6) * error, 1e-8);
  }
  EXPECT_NEAR(result.correlation(0, 1), inverse(0, 1) / std::sqrt(inverse(0, 0) * inverse(1, 1)), 1e-8);
  EXPECT_TRUE(result.findings.empty());
}

TEST(Fit, TrustsKnownNoise) {
  FitProblem problem = straight_line(line_x, line_y);
  problem.noise = NoiseScale::known;
  problem.series[0].uncertainty.assign(8, 0.2);
  const FitResult known = fit(problem);
  problem.series[0].uncertainty.assign(8, 0.4);
  EXPECT_NEAR(fit(problem).parameters[1].standard_error / known.parameters[1].standard_error, 2, 1e-8);
  EXPECT_EQ(known.noise_scale, 1);
}

TEST(Fit, WeighsSeriesByTheirUncertainty) {
  FitProblem problem = {{free_parameter("level", 1)},
                        {series({0, 0}, 1), series({3, 3}, 0.5)},
                        [](std::span<const double> p, std::span<double> y) {
                          for (double& one : y) one = p[0];
                        },
                        NoiseScale::estimated};
  EXPECT_NEAR(fit(problem).values[0], 3 * 4.0 / 5, 1e-10);
}

TEST(Fit, SaysWhenDataOnlyDetermineTheParameters) {
  const FitResult result = fit(straight_line({0, 1}, {1, 3}));
  EXPECT_NEAR(result.values[0], 1, 1e-10);
  EXPECT_NEAR(result.values[1], 2, 1e-10);
  EXPECT_EQ(result.degrees_of_freedom, 0);
  EXPECT_TRUE(std::isnan(result.parameters[0].standard_error));
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_EQ(result.findings[0].kind, FindingKind::exactly_determined);
  EXPECT_NE(result.findings[0].text.find("2 observations determine 2 parameters exactly"), std::string::npos);
}

/// y = a b^2 x + c: a and b enter only as a b^2, c is determined.
FitProblem product_problem() {
  const FitModel model = [](std::span<const double> p, std::span<double> y) {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = p[0] * p[1] * p[1] * line_x[i] + p[2];
  };
  return {{free_parameter("a", 1, ParameterScale::logarithmic),
           free_parameter("b", 1, ParameterScale::logarithmic), free_parameter("c", 1)},
          {series(line_y)},
          model,
          NoiseScale::estimated};
}

TEST(Fit, NamesCombinationsThatDataDoNotDetermine) {
  const FitResult result = fit(product_problem());
  EXPECT_EQ(result.parameters[0].outcome, ParameterOutcome::unidentifiable);
  EXPECT_EQ(result.parameters[1].outcome, ParameterOutcome::unidentifiable);
  EXPECT_EQ(result.parameters[2].outcome, ParameterOutcome::determined);
  EXPECT_EQ(result.parameters[0].standard_error, infinity);
  const FitResult line = fit(straight_line(line_x, line_y));
  EXPECT_NEAR(result.parameters[2].standard_error / line.parameters[0].standard_error, 1, 1e-5);
  EXPECT_EQ(result.degrees_of_freedom, 6);
  ASSERT_FALSE(result.findings.empty());
  EXPECT_EQ(result.findings[0].kind, FindingKind::unidentifiable);
  const bool one_way = result.findings[0].text.find("a by +1 % with b by -0.5 %") != std::string::npos;
  const bool other_way = result.findings[0].text.find("a by -1 % with b by +0.5 %") != std::string::npos;
  EXPECT_TRUE(one_way || other_way) << result.findings[0].text;
}

TEST(Fit, StopsAtBoundsAndSaysSo) {
  FitProblem problem = straight_line(line_x, line_y);
  problem.parameters[1].upper = 1.5;
  const FitResult result = fit(problem);
  EXPECT_EQ(result.values[1], 1.5);
  EXPECT_EQ(result.parameters[1].outcome, ParameterOutcome::at_bound);
  EXPECT_EQ(result.parameters[0].outcome, ParameterOutcome::determined);
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_EQ(result.findings[0].kind, FindingKind::at_bound);
}

TEST(Fit, KeepsFixedParameters) {
  FitProblem problem = straight_line(line_x, line_y);
  problem.parameters[0].role = ParameterRole::fixed;
  problem.parameters[0].initial = 2;
  const FitResult result = fit(problem);
  EXPECT_EQ(result.values[0], 2);
  EXPECT_EQ(result.parameters[0].outcome, ParameterOutcome::fixed);
  EXPECT_EQ(result.covariance.rows(), 1);
}

TEST(Fit, FindsTheBestOfManyStarts) {
  // cos(w x) has many minima in w; from w = 1 the search ends in a wrong one.
  std::vector<double> x, y;
  for (int i = 0; i < 40; ++i) {
    x.push_back(0.25 * i);
    y.push_back(std::cos(5.3 * 0.25 * i));
  }
  FitProblem problem = {{{"w", "1", 1, 0, 8, ParameterScale::linear, ParameterRole::free}},
                        {series(y)},
                        [x](std::span<const double> p, std::span<double> out) {
                          for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::cos(p[0] * x[i]);
                        },
                        NoiseScale::estimated};
  EXPECT_GT(fit(problem).chi_square, 1);
  FitOptions options;
  options.starts = 40;
  const FitResult result = fit(problem, options);
  EXPECT_NEAR(result.values[0], 5.3, 1e-9);
  EXPECT_GT(result.agreeing_starts, 0);
}

TEST(Fit, TurnsBackWhereTheModelFails) {
  const FitModel model = [](std::span<const double> p, std::span<double> y) {
    if (p[0] > 3) throw std::runtime_error("no such state");
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = p[0] * std::sqrt(line_x[i]);
  };
  FitProblem problem = {{free_parameter("p", 0.1)},
                        {series({0, 2.5, 3.5, 4.4, 5, 5.6, 6.1, 6.6})},
                        model,
                        NoiseScale::estimated};
  EXPECT_NEAR(fit(problem).values[0], 2.5, 0.02);
}

TEST(Fit, RefusesProblemsThatCannotBePosed) {
  FitProblem problem = straight_line(line_x, line_y);
  problem.parameters[0].lower = 3;
  EXPECT_THROW((void)fit(problem), InputError);
  problem = straight_line(line_x, line_y);
  problem.series[0].uncertainty[3] = 0;
  EXPECT_THROW((void)fit(problem), InputError);
  problem = straight_line(line_x, line_y);
  for (FitParameter& parameter : problem.parameters) parameter.role = ParameterRole::fixed;
  EXPECT_THROW((void)fit(problem), InputError);
  problem = straight_line(line_x, line_y);
  problem.model = [](std::span<const double>, std::span<double> y) { y[0] = std::nan(""); };
  EXPECT_THROW((void)fit(problem), InputError);
}

TEST(ProfileTest, EqualsTheLinearIntervalOfALine) {
  const FitProblem problem = straight_line(line_x, line_y);
  const FitResult result = fit(problem);
  for (std::size_t i = 0; i < 2; ++i) {
    const Profile found = profile(problem, result, i);
    const ConfidenceInterval linear = result.parameters[i].interval;
    const double width = linear.upper - linear.lower;
    EXPECT_NEAR(found.interval.lower, linear.lower, 2e-4 * width);
    EXPECT_NEAR(found.interval.upper, linear.upper, 2e-4 * width);
    EXPECT_TRUE(std::is_sorted(found.values.begin(), found.values.end()));
  }
}

TEST(ProfileTest, EndsWhereTheLeastSumOfSquaresReachesTheLimit) {
  const FitProblem problem = misra1a(ParameterScale::logarithmic);
  const FitResult result = fit(problem);
  const Profile found = profile(problem, result, 1);
  for (const double end : {found.interval.lower, found.interval.upper}) {
    // With b2 held, b1 is the ratio of two sums: the least sum of squares in closed form.
    double product = 0, square = 0, total = 0;
    for (std::size_t i = 0; i < misra_x.size(); ++i) {
      const double shape = -std::expm1(-end * misra_x[i]);
      product += shape * misra_y[i];
      square += shape * shape;
      total += misra_y[i] * misra_y[i];
    }
    EXPECT_NEAR((total - product * product / square) / found.limit, 1, 1e-3);
  }
}

TEST(ProfileTest, EndsWhereTheFitIsExact) {
  std::vector<double> y;
  for (const double x : line_x) y.push_back(1 + 2 * x);
  const FitProblem problem = straight_line(line_x, y);
  const FitResult result = fit(problem);
  const ConfidenceInterval interval = profile(problem, result, 1).interval;
  EXPECT_NEAR(interval.lower, 2, 1e-9);
  EXPECT_NEAR(interval.upper, 2, 1e-9);
}

TEST(ProfileTest, IsOpenWhereDataDoNotBound) {
  const FitProblem problem = product_problem();
  const ConfidenceInterval open = profile(problem, fit(problem), 0).interval;
  EXPECT_LT(open.lower, 1e-6);
  EXPECT_GT(open.upper, 1e6);
}

TEST(BootstrapTest, AgreesWithTheLinearErrors) {
  std::vector<double> x, y;
  for (std::uint32_t i = 0; i < 60; ++i) {
    x.push_back(0.1 * i);
    y.push_back(1 + 2 * x.back() + 0.3 * normal2(4, RandomStream::noise, {i})[0]);
  }
  const FitProblem problem = straight_line(x, y);
  const FitResult result = fit(problem);
  for (const BootstrapKind kind : {BootstrapKind::residuals, BootstrapKind::normal}) {
    const Bootstrap samples = bootstrap(problem, result, {1000, kind, 7, 0.95});
    EXPECT_EQ(samples.failed, 0);
    for (std::size_t i = 0; i < 2; ++i) {
      // 1000 samples know a standard error to 1/sqrt(2000) = 2.2 %; four of those, and of the interval's
      // ends.
      EXPECT_NEAR(samples.standard_errors[i] / result.parameters[i].standard_error, 1, 0.1);
      EXPECT_NEAR(samples.intervals[i].upper, result.parameters[i].interval.upper,
                  0.35 * result.parameters[i].standard_error);
    }
  }
  EXPECT_EQ(bootstrap(problem, result, {20, BootstrapKind::normal, 7, 0.95}).values,
            bootstrap(problem, result, {20, BootstrapKind::normal, 7, 0.95}).values);
}

TEST(BootstrapTest, RefusesAnExactFit) {
  const FitProblem problem = straight_line({0, 1}, {1, 3});
  EXPECT_THROW((void)bootstrap(problem, fit(problem), {}), InputError);
}

TEST(PredictionBandTest, EqualsTheFormulaOfALine) {
  const FitProblem problem = straight_line(line_x, line_y);
  const FitResult result = fit(problem);
  const FitModel at_ten = [](std::span<const double> p, std::span<double> y) { y[0] = p[0] + 10 * p[1]; };
  const PredictionBand band = predict_with_band(problem, result, {at_ten, {1}});
  // x mean 3.5, sum of squares 42: variance of the mean s^2 (1/8 + 6.5^2/42).
  const double mean = result.noise_scale * std::sqrt(1.0 / 8 + 6.5 * 6.5 / 42);
  const double t = student_quantile(0.95, 6);
  EXPECT_NEAR(band.curve[0].upper - band.predicted[0], t * mean, 1e-7);
  EXPECT_NEAR(band.observation[0].upper - band.predicted[0], t * std::hypot(mean, result.noise_scale), 1e-7);
}

TEST(SweepTest, FindsTheLeastAverageError) {
  FitProblem problem = {{free_parameter("p", 1)},
                        {series({2, 4}), series({6})},
                        [](std::span<const double> p, std::span<double> y) {
                          for (std::size_t i = 0; i < 3; ++i) y[i] = p[0] * 2 * static_cast<double>(i + 1);
                        },
                        NoiseScale::estimated};
  const Sweep found = sweep(problem, std::vector<double>{1}, {0, 0.1, 10, 41, ParameterScale::logarithmic});
  EXPECT_NEAR(found.best_value, 1, 1e-6);
  EXPECT_NEAR(found.best_error, 0, 1e-4);
  EXPECT_NEAR(found.errors.back(), 900, 1e-9);
  EXPECT_NEAR(found.series_errors[1].front(), 90, 1e-9);
  EXPECT_THROW((void)sweep(problem, std::vector<double>{1}, {0, 0, 10, 41, ParameterScale::logarithmic}),
               InputError);
}

TEST(AverageError, IsEquation48AndSkipsZeros) {
  const std::vector<double> observed = {2, 4, 0}, predicted = {3, 3, 1};
  EXPECT_NEAR(average_error_percent(observed, predicted), 37.5, 1e-12);
}

/// The interval holds the truth as often as it says: 2000 repetitions, standard deviation 0.49 %, so +- 2 %
/// is four.
TEST(Fit, IntervalsHoldTheTruthAsOftenAsTheySay) {
  int held = 0;
  for (std::uint32_t repetition = 0; repetition < 2000; ++repetition) {
    std::vector<double> y;
    for (std::uint32_t i = 0; i < 8; ++i)
      y.push_back(1 + 2 * line_x[i] + 0.5 * normal2(11, RandomStream::noise, {repetition, i})[0]);
    const ConfidenceInterval interval = fit(straight_line(line_x, y)).parameters[1].interval;
    held += interval.lower <= 2 && 2 <= interval.upper ? 1 : 0;
  }
  EXPECT_NEAR(held / 2000.0, 0.95, 0.02);
}

}  // namespace
}  // namespace fiberfate
