// Tests the optimum of a sweep against lengths that are known functions of the parameter.
#include "calibration/length_sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr double true_value = 2e-3;

/// A length that decays from 5 mm to 1 mm, L = 1 + 4 exp(-xi t) mm, as DL/Dt = -k_f (L - L_inf) gives.
double length_at(double value, double strain) {
  return 1e-3 + 4e-3 * std::exp(-value * strain);
}

std::vector<double> swept_values() {
  std::vector<double> values;
  for (int i = 0; i < 15; ++i) values.push_back(3e-4 * std::pow(40.0, i / 14.0));
  return values;
}

/// Samples that are off by these relative errors.
SweptLength swept_length(double strain, std::initializer_list<double> errors) {
  SweptLength length;
  for (const double error : errors) length.measured.push_back(length_at(true_value, strain) * (1 + error));
  for (const double value : swept_values()) length.predicted.push_back(length_at(value, strain));
  return length;
}

TEST(LengthSweep, FindsTheValueThatMeasurementsWithoutNoiseCameFrom) {
  const SweepOutcome outcome = evaluate_sweep(
      swept_values(), {swept_length(300, {0}), swept_length(600, {0}), swept_length(1000, {0})});
  // The spline through 15 values and the grid of 200 places between two of them: 1e-3 of the value.
  EXPECT_NEAR(outcome.best_value, true_value, 2e-3 * true_value);
  EXPECT_NEAR(outcome.least_squares_value, true_value, 2e-3 * true_value);
  EXPECT_LT(outcome.best_error, 0.1);
  EXPECT_EQ(outcome.errors.size(), 15U);
  for (const double error : outcome.errors) EXPECT_GE(error, outcome.best_error);
}

TEST(LengthSweep, TellsTheAverageErrorOfTheThesis) {
  // Samples of one place are averaged before they are compared.
  const SweptLength one = swept_length(600, {0.15, 0.35});
  const double measured = 1.25 * length_at(true_value, 600);
  const SweepOutcome outcome = evaluate_sweep(swept_values(), {one});
  for (std::size_t i = 0; i < outcome.errors.size(); ++i)
    EXPECT_NEAR(outcome.errors[i], 100 * std::abs(one.predicted[i] - measured) / measured, 1e-9);
}

TEST(LengthSweep, TellsHowWellTheValueIsKnown) {
  // Two measurements of one place with errors of +e and -e: the scatter is sqrt(2) e with one degree of
  // freedom, and the standard error of ln(xi) is the scatter over the root of the summed squares of d ln L /
  // d ln xi.
  const double error = 0.02, strain = 600;
  const SweepOutcome outcome = evaluate_sweep(swept_values(), {swept_length(strain, {error, -error})});
  const double x = true_value * strain;
  const double slope = -4e-3 * x * std::exp(-x) / length_at(true_value, strain);
  EXPECT_NEAR(outcome.least_squares_error, std::sqrt(2.0) * error, 0.02 * error);
  EXPECT_NEAR(outcome.standard_error, outcome.least_squares_error / (std::sqrt(2.0) * std::abs(slope)),
              0.02 * outcome.standard_error);
}

TEST(LengthSweep, RefusesWhatCannotBeSwept) {
  const SweptLength one = swept_length(600, {0});
  const std::vector<double> values = swept_values();
  SweptLength unmeasured = one, shorter = one, negative = one;
  unmeasured.measured.clear();
  shorter.predicted.pop_back();
  negative.predicted[3] = -1e-3;
  const auto refused = [](const std::vector<double>& some, const std::vector<SweptLength>& lengths) {
    EXPECT_THROW(static_cast<void>(evaluate_sweep(some, lengths)), InputError);
  };
  refused({}, {});
  refused({values[0], values[1]}, {one});
  refused({values.rbegin(), values.rend()}, {one});
  refused(values, {});
  for (const SweptLength& wrong : {unmeasured, shorter, negative}) refused(values, {one, wrong});
}

}  // namespace
}  // namespace fiberfate
