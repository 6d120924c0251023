// Checks the C interface: the same numbers as C++, every fault a status with words, nothing thrown.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "continuum/fiberfate.h"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/phelps_solver.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {
namespace {

const std::vector<double> state = {0.5, 0.3, 0.2, 0.02, 0.04, 0.1};
const std::vector<double> gradient = {0.1, 0.4, 2, -0.3, 0.2, 0.5, 0.1, 0, -0.3};

TEST(CApi, RatesEqualThoseOfTheLaw) {
  const fiberfate_constant constants[] = {{"c_i", 0.02}, {"c_m", 0.9}, {"alpha", 0.8}};
  fiberfate_orientation_law* law = nullptr;
  ASSERT_EQ(fiberfate_orientation_create("iard_rpr", "ore", constants, 3, &law), FIBERFATE_OK);
  std::vector<double> states, gradients, rates(6 * 11);
  for (int i = 0; i < 11; ++i) {
    states.insert(states.end(), state.begin(), state.end());
    gradients.insert(gradients.end(), gradient.begin(), gradient.end());
  }
  ASSERT_EQ(fiberfate_orientation_rates(law, 11, states.data(), gradients.data(), rates.data()),
            FIBERFATE_OK);
  OrientationModel model = orientation_model_named("iard_rpr", "ore");
  for (const fiberfate_constant& one : constants) set_constant(model, one.name, one.value);
  const Mat3 second = to_matrix(Eigen::Map<const Vec6>(state.data()));
  const Mat3 l = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(gradient.data());
  const Vec6 expected = to_components(OrientationLaw(model).rate(second, l));
  for (int i = 0; i < 11; ++i)
    for (int m = 0; m < 6; ++m) EXPECT_EQ(rates[static_cast<std::size_t>(6 * i + m)], expected[m]);
  ASSERT_EQ(fiberfate_orientation_advance(law, 11, states.data(), gradients.data(), 0.5, 1e-8), FIBERFATE_OK);
  EXPECT_NEAR(states[60] + states[61] + states[62], 1, 1e-15);
  fiberfate_orientation_destroy(law);
}

TEST(CApi, AnyPairOfDiffusionAndRetardationIsALaw) {
  fiberfate_orientation_law* law = nullptr;
  EXPECT_EQ(fiberfate_orientation_create("mrd+rsc", "ibof", nullptr, 0, &law), FIBERFATE_OK);
  EXPECT_NE(law, nullptr);
  fiberfate_orientation_destroy(law);
}

TEST(CApi, FaultsAreToldInWords) {
  fiberfate_orientation_law* law = nullptr;
  EXPECT_EQ(fiberfate_orientation_create("iard-rpr", "ibof", nullptr, 0, &law), FIBERFATE_BAD_INPUT);
  EXPECT_EQ(law, nullptr);
  EXPECT_NE(std::string(fiberfate_error_text()).find("iard_rpr"), std::string::npos)
      << fiberfate_error_text();
  const fiberfate_constant forgotten = {"kappa", 0.1};
  EXPECT_EQ(fiberfate_orientation_create("iard", "ibof", &forgotten, 1, &law), FIBERFATE_BAD_INPUT);
  EXPECT_NE(std::string(fiberfate_error_text()).find("not read"), std::string::npos);
  EXPECT_EQ(fiberfate_orientation_create("iard", nullptr, nullptr, 0, &law), FIBERFATE_BAD_INPUT);
  EXPECT_EQ(fiberfate_orientation_rates(nullptr, 1, state.data(), gradient.data(), nullptr),
            FIBERFATE_BAD_INPUT);
  fiberfate_length_law* length = nullptr;
  EXPECT_EQ(fiberfate_length_create("phelps", nullptr, 0, &length), FIBERFATE_BAD_INPUT);
  EXPECT_EQ(fiberfate_length_create("no_such_law", nullptr, 0, &length), FIBERFATE_BAD_INPUT);
  EXPECT_EQ(length, nullptr);
  fiberfate_orientation_destroy(nullptr);
  fiberfate_length_destroy(nullptr);
  EXPECT_EQ(fiberfate_api_version(), FIBERFATE_API_VERSION);
}

TEST(CApi, ClosesFourthOrderTensors) {
  std::vector<double> fourth(36);
  ASSERT_EQ(fiberfate_close("ibof", 1, state.data(), fourth.data()), FIBERFATE_OK);
  EXPECT_NEAR(fourth[0] + fourth[1] + fourth[2], state[0], 1e-12);
}

TEST(CApi, BreakageEqualsTheSolversAndKeepsTheLength) {
  const fiberfate_constant constants[] = {{"C_B", 0.02}, {"zeta", 3}, {"S", 0.25}};
  fiberfate_breakage_law* law = nullptr;
  ASSERT_EQ(fiberfate_breakage_create("phelps", constants, 3, 50, 15e-3, &law), FIBERFATE_OK);
  const std::vector<double> rates = {50, 200, 1000}, viscosities = {300, 200, 80}, shielded = {1, 0.5, 0.2};
  std::vector<double> numbers(3 * 50, 1.0), breakage(3 * 50);
  ASSERT_EQ(fiberfate_breakage_rates(law, 3, rates.data(), viscosities.data(), nullptr, breakage.data()),
            FIBERFATE_OK);
  ASSERT_EQ(fiberfate_breakage_advance(law, 3, rates.data(), viscosities.data(), shielded.data(), 0.5,
                                       numbers.data()),
            FIBERFATE_OK);
  const PhelpsSolver solver({0.02, 3, 0.25, 73e9, 19e-6, 0, PhelpsBreakage::share}, {50, 15e-3});
  std::vector<double> expected(3 * 50, 1.0);
  solver.advance({rates, viscosities, shielded}, 0.5, expected);
  EXPECT_EQ(numbers, expected);
  double length = 0;
  for (std::size_t bin = 0; bin < 50; ++bin) {
    EXPECT_EQ(breakage[3 * bin + 1], solver.breakage_rates({200, 200, 1})[bin]);
    length += numbers[3 * bin + 2] * static_cast<double>(bin + 1);
  }
  EXPECT_NEAR(length, 51 * 25, 1e-9);
  fiberfate_breakage_destroy(law);
  EXPECT_EQ(fiberfate_breakage_create("constant", nullptr, 0, 50, 15e-3, &law), FIBERFATE_BAD_INPUT);
  EXPECT_EQ(fiberfate_breakage_create("phelps", constants, 3, 1, 15e-3, &law), FIBERFATE_BAD_INPUT);
  EXPECT_EQ(fiberfate_breakage_create("phelps", constants, 3, 50, -1, &law), FIBERFATE_BAD_INPUT);
  EXPECT_EQ(law, nullptr);
  fiberfate_breakage_destroy(nullptr);
}

}  // namespace
}  // namespace fiberfate
