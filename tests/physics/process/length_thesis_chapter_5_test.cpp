// Recomputes every number of thesis equations (5.1) to (5.18), with the formulas that were really used.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "continuum/couette_rheometer.hpp"
#include "continuum/length_relaxation.hpp"
#include "continuum/stress_induced.hpp"
#include "continuum/unbreakable_length.hpp"

namespace fiberfate {
namespace {

/// Thesis numbers in SI: its stresses and strength are in dyn/cm^2 (0.1 Pa), its lengths in mm.
class ThesisChapter5 : public testing::Test {
 protected:
  ThesisChapter5() {
    std::ifstream file(FIBERFATE_SOURCE_DIR "/tests/reference/thesis_ch5.json");
    reference_ = nlohmann::json::parse(file);
    const auto& in = reference_.at("inputs");
    runs_ = {run(in.at("gdot_50"), in.at("tau_50"), in.at("kf_50"), in.at("L_inf_50_mm")),
             run(in.at("gdot_100"), in.at("tau_100"), in.at("kf_100"), in.at("L_inf_100_mm"))};
    strength_ = 0.1 * in.at("sigma_u").get<double>();
    diameter_ = 1e-3 * in.at("d_f_mm").get<double>();
  }

  static SteadyAttrition run(double rate, double stress_in_cgs, double rate_constant, double length_in_mm) {
    return {rate, 0.1 * stress_in_cgs / rate, {rate_constant, 1e-3 * length_in_mm}};
  }
  [[nodiscard]] double value(const char* equation, std::size_t entry = 0) const {
    return reference_.at("equations").at(equation).at(entry).at("value");
  }

  nlohmann::json reference_;
  std::array<SteadyAttrition, 2> runs_;
  double strength_ = 0;
  double diameter_ = 0;
};

constexpr double round_off = 1e-13;

TEST_F(ThesisChapter5, InteractionCoefficientsDifferBetweenSpeeds) {
  EXPECT_NEAR(interaction_coefficient(runs_[0], 0.5, strength_, diameter_) / value("5.1"), 1, round_off);
  EXPECT_NEAR(interaction_coefficient(runs_[1], 0.5, strength_, diameter_) / value("5.2"), 1, round_off);
}

TEST_F(ThesisChapter5, FourConstantsFollowFromTwoRuns) {
  const StressInduced law = solve_stress_induced(runs_, strength_, diameter_);
  EXPECT_NEAR(law.alpha / value("5.12"), 1, round_off);
  EXPECT_NEAR(law.lambda / value("5.13"), 1, 1e-12);
  EXPECT_NEAR(interaction_coefficient(runs_[1], law.alpha, strength_, diameter_) / value("5.13b"), 1, 1e-12);
  EXPECT_NEAR(interaction_coefficient(runs_[0], 1.353462, strength_, diameter_) / value("5.13c"), 1, 1e-12);
  EXPECT_NEAR(law.beta / value("5.16b"), 1, round_off);
  EXPECT_NEAR(rate_exponent(runs_) / value("5.15"), 1, round_off);
}

TEST_F(ThesisChapter5, RateConstantsWithTheStressesOfEachEquation) {
  const auto with_stresses = [this](double first, double second) {
    std::array<SteadyAttrition, 2> runs = runs_;
    runs[0].viscosity = 0.1 * first / runs[0].rate;
    runs[1].viscosity = 0.1 * second / runs[1].rate;
    return solve_stress_induced(runs, strength_, diameter_);
  };
  EXPECT_NEAR(with_stresses(49584, 82749).beta / value("5.16"), 1, 1e-12);
  const StressInduced law = with_stresses(49584.86, 82749.23);
  EXPECT_NEAR(law.beta / value("5.16c"), 1, 1e-12);
  EXPECT_NEAR(law.k_0 / value("5.17", 2), 1, 1e-11);
  EXPECT_NEAR(law.k_0 / value("5.18", 2), 1, 1e-11);
  const auto k_0 = [&](double rate_constant, double stress, double beta) {
    return rate_constant / std::pow(0.1 * stress / strength_, beta);
  };
  EXPECT_NEAR(k_0(0.0279, 49584.86, 1.1392) / value("5.17", 0), 1, 1e-12);
  EXPECT_NEAR(k_0(0.0500, 82749.23, 1.1392) / value("5.18", 0), 1, 1e-12);
  EXPECT_NEAR(k_0(0.0279, 49584.86, value("5.16")) / value("5.17", 1), 1, 1e-12);
  EXPECT_NEAR(k_0(0.0500, 82749.23, value("5.16")) / value("5.18", 1), 1, 1e-12);
}

TEST_F(ThesisChapter5, LengthsOverTimeFollowTheLaw) {
  const StressInduced law = solve_stress_induced(runs_, strength_, diameter_);
  for (const auto& point : reference_.at("length_curves_eq5_7")) {
    const double time = point.at("t");
    const LengthFlow slow = {runs_[0].rate, runs_[0].viscosity};
    const LengthFlow fast = {runs_[1].rate, runs_[1].viscosity};
    EXPECT_NEAR(relax_length(15e-3, law(slow), time), 1e-3 * point.at("L50").get<double>(), 1e-14);
    EXPECT_NEAR(relax_length(15e-3, law(fast), time), 1e-3 * point.at("L100").get<double>(), 1e-14);
    const double y = (relax_length(15e-3, law(slow), time) - 1.5e-3) / 13.5e-3;
    EXPECT_NEAR(y, point.at("y50").get<double>(), 1e-12);
  }
}

/// A strength of 2e10 taken as Pa against stresses in Pa is the unit trap: same curves, other constants.
TEST_F(ThesisChapter5, AStrengthInTheWrongUnitHidesInTheConstants) {
  const StressInduced right = solve_stress_induced(runs_, strength_, diameter_);
  const StressInduced wrong = solve_stress_induced(runs_, 10 * strength_, diameter_);
  EXPECT_NEAR(wrong.lambda / right.lambda, std::pow(10, -right.alpha), 1e-13);
  EXPECT_NEAR(wrong.k_0 / right.k_0, std::pow(10, right.beta), 1e-11);
  const LengthFlow other_flow = {100, 150};
  EXPECT_NEAR(wrong(other_flow).equilibrium_length / right(other_flow).equilibrium_length, 1, 1e-12);
  EXPECT_NEAR(wrong(other_flow).rate_constant / right(other_flow).rate_constant, 1, 1e-12);
}

TEST_F(ThesisChapter5, RatesFollowFromTheSpeeds) {
  const auto& derived = reference_.at("derived");
  const double per_turn = derived.at("gdot_per_rpm");
  // (inner radius)/(gap) = 3.5 in the narrow-gap formula; the printed rates are rounded to five digits.
  const CouetteRheometer rheometer = {0.021, 0.027, 1, CouetteRate::narrow_gap};
  EXPECT_NEAR(shear_rate(rheometer, 1) / per_turn, 1, 1e-14);
  EXPECT_NEAR(shear_rate(rheometer, 50), runs_[0].rate, 5e-4);
  EXPECT_NEAR(shear_rate(rheometer, 100), runs_[1].rate, 5e-4);
}

}  // namespace
}  // namespace fiberfate
