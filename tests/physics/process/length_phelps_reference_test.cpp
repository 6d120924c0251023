// Compares the Phelps-Tucker solver with an independent solution of the same equations (matrix exponential).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "continuum/durin_breakage.hpp"
#include "continuum/phelps_solver.hpp"

namespace fiberfate {
namespace {

nlohmann::json read_reference() {
  std::ifstream file(FIBERFATE_SOURCE_DIR "/tests/reference/phelps_fld.json");
  return nlohmann::json::parse(file);
}

/// The reference's lengths are in units of L_ub and its times in units of 1/(C_B rate); so are ours with
/// these.
PhelpsSolver dimensionless_solver(const nlohmann::json& fld) {
  const double width = fld.at("dL");
  const std::size_t bins = fld.at("nbins");
  PhelpsConstants constants;
  constants.breakage_coefficient = 1;
  constants.spread = fld.at("S");
  constants.unbreakable_length = 1;
  return PhelpsSolver(constants, {bins, width * static_cast<double>(bins)});
}

void expect_state(const nlohmann::json& expected, const LengthBins& bins,
                  const std::vector<double>& numbers) {
  const double time = expected.at("tstar");
  const MeanLengths means = mean_lengths(bins.lengths(), numbers);
  EXPECT_NEAR(means.number_average / expected.at("LN").get<double>(), 1, 1e-9) << "t* = " << time;
  EXPECT_NEAR(means.weight_average / expected.at("LW").get<double>(), 1, 1e-9) << "t* = " << time;
  EXPECT_NEAR(total_length({bins.lengths(), numbers}) / 15, 1, 1e-12) << "t* = " << time;
  const std::vector<double> reference = expected.at("N");
  ASSERT_EQ(reference.size(), numbers.size());
  const double most = *std::max_element(reference.begin(), reference.end());
  for (std::size_t i = 0; i < reference.size(); ++i)
    EXPECT_NEAR(numbers[i], reference[i], 1e-10 * most) << "t* = " << time << ", bin " << i;
}

TEST(PhelpsReference, EveryTimeInOneStep) {
  for (const auto& fld : read_reference().at("cases")) {
    const PhelpsSolver solver = dimensionless_solver(fld);
    for (const auto& expected : fld.at("times")) {
      std::vector<double> numbers(solver.bins().bins, 0.0);
      numbers.back() = 1;
      solver.advance({1, 1}, expected.at("tstar"), numbers);
      expect_state(expected, solver.bins(), numbers);
    }
  }
}

TEST(PhelpsReference, ManySmallStepsInARow) {
  for (const auto& fld : read_reference().at("cases")) {
    const PhelpsSolver solver = dimensionless_solver(fld);
    std::vector<double> numbers(solver.bins().bins, 0.0);
    numbers.back() = 1;
    double before = 0;
    for (const auto& expected : fld.at("times")) {
      const double time = expected.at("tstar");
      for (int i = 0; i < 100; ++i) solver.advance({1, 1}, (time - before) / 100, numbers);
      before = time;
      expect_state(expected, solver.bins(), numbers);
    }
  }
}

TEST(PhelpsReference, ChildrenOfEightBins) {
  const nlohmann::json reference = read_reference().at("Rstar_n8_S025");
  const std::vector<double> children = child_numbers(8, 0.25);
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t k = i + 1; k < 8; ++k)
      EXPECT_NEAR(children[i + 8 * k], reference[i][k].get<double>(), 1e-14) << i << ", " << k;
  }
}

/// Twice the rate and half the time is the same: time enters only as strain when the stress is kept.
TEST(PhelpsScaling, TwiceTheRateHalfTheTime) {
  const PhelpsSolver solver({0.02, 3, 0.25, 73e9, 19e-6, 0, PhelpsBreakage::share}, {100, 15e-3});
  std::vector<double> slow(100, 1.0), fast(100, 1.0);
  solver.advance({50, 200}, 4, slow);
  solver.advance({100, 100}, 2, fast);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_NEAR(slow[i], fast[i], 1e-12 * (1 + slow[i]));
}

/// Lengths scale with L_ub: a viscosity 16 times lower doubles L_ub and, with doubled bins, changes no
/// number.
TEST(PhelpsScaling, LengthsScaleWithTheUnbreakableLength) {
  const PhelpsConstants constants = {0.02, 3, 0.25, 73e9, 19e-6, 0, DurinBreakage::share};
  std::vector<double> thin(60, 1.0), thick(60, 1.0);
  PhelpsSolver(constants, {60, 8e-3}).advance({50, 200}, 4, thick);
  PhelpsSolver(constants, {60, 16e-3}).advance({50, 12.5}, 4, thin);
  for (std::size_t i = 0; i < 60; ++i) EXPECT_NEAR(thin[i] / thick[i], 1, 1e-12);
}

/// Mean lengths converge as bins become finer: the second difference shrinks at least linearly with the
/// width.
TEST(PhelpsBins, ConvergeWithTheirNumber) {
  const auto number_average = [](std::size_t bins) {
    const PhelpsSolver solver({0.02, 3, 0.25, 73e9, 19e-6, 0, DurinBreakage::share}, {bins, 15e-3});
    std::vector<double> numbers(bins, 0.0);
    numbers.back() = 1;
    solver.advance({50, 200}, 3, numbers);
    return mean_lengths(solver.bins().lengths(), numbers).number_average;
  };
  const double coarse = number_average(50), middle = number_average(100), fine = number_average(200);
  EXPECT_LT(std::abs(fine - middle), 0.6 * std::abs(middle - coarse));
  EXPECT_LT(std::abs(fine - middle) / fine, 0.02);
}

}  // namespace
}  // namespace fiberfate
