// Tests the Phelps-Tucker model: its rates, its children, its exact steps.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/error.hpp"
#include "base/random.hpp"
#include "base/threads.hpp"
#include "continuum/durin_breakage.hpp"
#include "continuum/phelps_solver.hpp"

namespace fiberfate {
namespace {

const PhelpsConstants glass = {0.02, 3, 0.25, 73e9, 19e-6, 0, PhelpsBreakage::share};
const LengthFlow flow = {50, 200, 1};

/// The matrix of dN/dt = M N, built straight from its definition.
Eigen::MatrixXd rate_matrix(const PhelpsSolver& solver, const LengthFlow& at) {
  const auto n = static_cast<Eigen::Index>(solver.bins().bins);
  const std::vector<double> children = child_numbers(solver.bins().bins, solver.constants().spread);
  const std::vector<double> rates = solver.breakage_rates(at);
  Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd>(children.data(), n, n);
  matrix.diagonal().array() -= 1;
  return matrix * Eigen::Map<const Eigen::VectorXd>(rates.data(), n).asDiagonal();
}

/// Taylor series in many tiny steps: slow, but there is nothing to get wrong.
std::vector<double> advance_slowly(const Eigen::MatrixXd& matrix, double duration,
                                   std::vector<double> numbers) {
  constexpr int steps = 400;
  Eigen::Map<Eigen::VectorXd> state(numbers.data(), matrix.rows());
  for (int i = 0; i < steps; ++i) {
    Eigen::VectorXd term = state;
    for (int k = 1; k <= 20; ++k) {
      term = matrix * term * (duration / steps / k);
      state += term;
    }
  }
  return numbers;
}

double length_of(const std::vector<double>& numbers) {
  double sum = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) sum += numbers[i] * static_cast<double>(i + 1);
  return sum;
}

TEST(UnbreakableLength, IsWhereDragEqualsTheBucklingLoad) {
  // Thesis (2.7) F = pi^3 E D^4/(64 L^2) against zeta eta rate L^2/16, the drag on half a fiber along the
  // worst axis.
  const double length = unbreakable_length(glass, flow);
  const double buckling =
      std::pow(std::numbers::pi, 3) * glass.modulus * std::pow(glass.diameter, 4) / (64 * length * length);
  const double drag = glass.drag_coefficient * flow.viscosity * flow.rate * length * length / 16;
  EXPECT_NEAR(drag / buckling, 1, 1e-13);
  EXPECT_EQ(unbreakable_length(glass, {0, 200}), HUGE_VAL);
}

TEST(BreakageShare, FollowsPhelpsAndDurin) {
  EXPECT_EQ(PhelpsBreakage::share(0.999), 0);
  EXPECT_EQ(PhelpsBreakage::share(1), 0);
  EXPECT_NEAR(PhelpsBreakage::share(16), 1 - std::exp(-15.0), 1e-16);
  EXPECT_EQ(PhelpsBreakage::share(1e6), 1);
  EXPECT_NEAR(DurinBreakage::share(0.5), (1 - std::exp(-0.5)) / (1 - std::exp(-1.0)), 1e-16);
  EXPECT_EQ(DurinBreakage::share(1), 1);
  EXPECT_EQ(DurinBreakage::share(0), 0);
}

TEST(ChildNumbers, KeepTwoChildrenAndTheWholeLength) {
  for (const double spread : {0.005, 0.05, 0.25, 1.0, 50.0}) {
    const std::vector<double> children = child_numbers(100, spread);
    for (std::size_t k = 2; k <= 100; ++k) {
      double number = 0, length = 0;
      for (std::size_t i = 1; i <= 100; ++i) {
        const double child = children[i - 1 + (k - 1) * 100];
        ASSERT_TRUE(i < k ? child >= 0 : child == 0);
        number += child;
        length += child * static_cast<double>(i);
      }
      EXPECT_NEAR(number, 2, 4e-15);
      EXPECT_NEAR(length / static_cast<double>(k), 1, 4e-15);
    }
  }
  EXPECT_EQ(child_numbers(100, 0.25)[0], 0);
}

TEST(ChildNumbers, RefuseWhatBinsCannotResolve) {
  EXPECT_THROW((void)child_numbers(1, 0.25), InputError);
  EXPECT_THROW((void)child_numbers(10, 0.004), InputError);
  EXPECT_THROW((void)child_numbers(10, std::nan("")), InputError);
}

class PhelpsSteps : public testing::TestWithParam<std::tuple<std::size_t, BreakageShare, double>> {};

TEST_P(PhelpsSteps, EqualTheSlowReference) {
  const auto [bins, share, events] = GetParam();
  PhelpsConstants constants = glass;
  constants.share = share;
  const PhelpsSolver solver(constants, {bins, 15e-3});
  std::vector<double> numbers(bins);
  for (std::size_t i = 0; i < bins; ++i)
    numbers[i] = uniform(1, RandomStream::noise, {static_cast<std::uint32_t>(i)});
  const double duration = events / (constants.breakage_coefficient * flow.rate);
  const std::vector<double> expected = advance_slowly(rate_matrix(solver, flow), duration, numbers);
  const double length = length_of(numbers);
  solver.advance(flow, duration, numbers);
  for (std::size_t i = 0; i < bins; ++i) EXPECT_NEAR(numbers[i], expected[i], 1e-11 * std::abs(length));
  EXPECT_NEAR(length_of(numbers) / length, 1, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(BinsRatesAndEvents, PhelpsSteps,
                         testing::Combine(testing::Values(2U, 7U, 100U, 133U),
                                          testing::Values(PhelpsBreakage::share, DurinBreakage::share),
                                          testing::Values(1e-6, 0.1, 3.0, 40.0)));

TEST(PhelpsSolver, DoesNotDependOnTheStepOrTheThreadsOrTheNeighbours) {
  constexpr std::size_t points = 37, bins = 50;
  const PhelpsSolver solver(glass, {bins, 12e-3});
  std::vector<double> rates(points), viscosities(points, 150), compression(points),
      numbers(points * bins, 0.0);
  for (std::size_t i = 0; i < points; ++i) {
    rates[i] = 5.0 * static_cast<double>(i);
    compression[i] = 1 - 0.02 * static_cast<double>(i);
    for (std::size_t k = 0; k < bins; ++k) numbers[k * points + i] = static_cast<double>((k * 7 + i) % 11);
  }
  std::vector<double> batch = numbers;
  solver.advance({rates, viscosities, compression}, 2.0, batch);
  std::vector<double> serial = numbers;
  const int threads = thread_count();
  use_threads(1);
  solver.advance({rates, viscosities, compression}, 2.0, serial);
  use_threads(threads);
  EXPECT_EQ(serial, batch);
  for (int step = 0; step < 10; ++step) solver.advance({rates, viscosities, compression}, 0.2, numbers);
  for (std::size_t i = 0; i < batch.size(); ++i) EXPECT_NEAR(numbers[i], batch[i], 1e-10);
  std::vector<double> alone(bins);
  for (std::size_t k = 0; k < bins; ++k) alone[k] = static_cast<double>((k * 7 + 20) % 11);
  solver.advance({rates[20], 150, compression[20]}, 2.0, alone);
  for (std::size_t k = 0; k < bins; ++k) EXPECT_NEAR(alone[k], batch[k * points + 20], 1e-11);
}

TEST(PhelpsSolver, NeverLengthensAndStaysPositive) {
  const PhelpsSolver solver(glass, {100, 15e-3});
  std::vector<double> numbers(100, 0.0);
  numbers[99] = 1;
  const std::vector<double> lengths = solver.bins().lengths();
  MeanLengths before = mean_lengths(lengths, numbers);
  for (int step = 0; step < 300; ++step) {
    solver.advance(flow, 0.03, numbers);
    const MeanLengths now = mean_lengths(lengths, numbers);
    EXPECT_LE(now.number_average, before.number_average * (1 + 1e-15));
    EXPECT_LE(now.weight_average, before.weight_average * (1 + 1e-15));
    for (const double number : numbers) ASSERT_GE(number, 0);
    before = now;
  }
  EXPECT_NEAR(length_of(numbers) / 100, 1, 1e-12);
}

TEST(PhelpsSolver, TakesHugeStepsAndNoFlow) {
  const PhelpsSolver solver(glass, {100, 15e-3});
  std::vector<double> numbers(100, 1.0);
  const std::vector<double> start = numbers;
  solver.advance({0, 200}, 1e6, numbers);
  EXPECT_EQ(numbers, start);
  solver.advance(flow, 0, numbers);
  EXPECT_EQ(numbers, start);
  solver.advance(flow, 1e5, numbers);
  const double limit = unbreakable_length(glass, flow);
  for (std::size_t i = 0; i < 100; ++i) {
    if (solver.bins().length(i) > 1.1 * limit) {
      EXPECT_LT(numbers[i], 1e-12);
    }
  }
  EXPECT_NEAR(length_of(numbers) / length_of(start), 1, 1e-12);
}

TEST(PhelpsSolver, RefusesBadConstants) {
  EXPECT_THROW(PhelpsSolver({0.02, 0, 0.25, 73e9, 19e-6, 0, PhelpsBreakage::share}, {100, 1e-2}), InputError);
  EXPECT_THROW(PhelpsSolver({-1, 3, 0.25, 73e9, 19e-6, 0, PhelpsBreakage::share}, {100, 1e-2}), InputError);
  EXPECT_THROW(PhelpsSolver(glass, {100, 0}), InputError);
  EXPECT_NO_THROW(PhelpsSolver({0.02, 0, 0.25, 0, 0, 1e-3, PhelpsBreakage::share}, {100, 1e-2}));
}

TEST(SortIntoBins, KeepsNumberAndLength) {
  const LengthBins bins = {10, 10e-3};
  const LengthClasses classes = {{0.4e-3, 1e-3, 2.5e-3, 10e-3, 9.99e-3}, {10, 1, 4, 2, 3}};
  const std::vector<double> numbers = sort_into_bins(classes, bins);
  EXPECT_NEAR(total_length({bins.lengths(), numbers}), total_length(classes), 1e-16);
  EXPECT_NEAR(numbers[0], 10 * 0.4 + 1, 1e-12);
  EXPECT_NEAR(numbers[1], 2, 1e-12);
  EXPECT_NEAR(numbers[2], 2, 1e-12);
  EXPECT_NEAR(numbers[8] + numbers[9], 5, 1e-12);
  EXPECT_THROW((void)sort_into_bins({{11e-3}, {1}}, bins), InputError);
}

TEST(SortIntoBins, PutsMultiplesOfTheWidthIntoOneBin) {
  const LengthBins bins = {100, 15e-3};
  for (std::size_t i = 0; i < 100; ++i) {
    const std::vector<double> numbers = sort_into_bins({{bins.length(i)}, {1}}, bins);
    EXPECT_EQ(numbers[i], 1) << i;
  }
}

}  // namespace
}  // namespace fiberfate
