// Tests the viscosity laws against their own limits and against hand-computed values.
#include "continuum/viscosity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "continuum/viscosity_carreau.hpp"
#include "continuum/viscosity_cross.hpp"
#include "continuum/viscosity_cross_wlf.hpp"
#include "continuum/viscosity_newtonian.hpp"
#include "continuum/viscosity_power_law.hpp"

namespace fiberfate {
namespace {

TEST(Viscosity, NewtonianIsConstant) {
  EXPECT_EQ(Newtonian{200}({0}), 200);
  EXPECT_EQ(Newtonian{200}({1e6, 500, 1e8}), 200);
}

TEST(Viscosity, PowerLawHasItsSlopeAndAFloor) {
  const PowerLaw law = {11000, 0.35, 1e-3};
  EXPECT_NEAR(law({100}), 11000 * std::pow(100, -0.65), 1e-10);
  EXPECT_NEAR(std::log10(law({1e4}) / law({1e3})), -0.65, 1e-14);
  EXPECT_EQ(law({0}), law({1e-3}));
}

TEST(Viscosity, CarreauGoesFromPlateauToPowerLaw) {
  const Carreau law = {1000, 0.5, 0.3};
  EXPECT_EQ(law({0}), 1000);
  EXPECT_NEAR(law({2}), 1000 * std::pow(2, -0.35), 1e-10);
  EXPECT_NEAR(law({1e8}) / (1000 * std::pow(0.5e8, -0.7)), 1, 1e-12);
  const Carreau yasuda = {1000, 0.5, 0.3, 10, 0.8};
  EXPECT_NEAR(yasuda({2}), 10 + 990 * std::pow(2, -0.7 / 0.8), 1e-10);
  EXPECT_NEAR(yasuda({1e30}), 10, 1e-10);
}

TEST(Viscosity, CrossIsHalfAtItsCriticalStress) {
  const Cross law = {1000, 25000, 0.3};
  EXPECT_EQ(law({0}), 1000);
  EXPECT_NEAR(law({25}), 500, 1e-12);
  EXPECT_NEAR(law({1e10}) / (1000 * std::pow(1e10 / 25, -0.7)), 1, 1e-5);
}

TEST(Viscosity, CrossWlfShiftsWithTemperatureAndPressure) {
  const CrossWlf law = {25000, 0.3, 4e12, 263.15, 1.5e-7, 28, 51.6};
  // By hand: T - T_s = 523.15 - 263.15 = 260 K; exponent -28*260/311.6.
  const double at_rest = 4e12 * std::exp(-28 * 260 / 311.6);
  EXPECT_NEAR(law({0, 523.15, 0}) / at_rest, 1, 1e-12);
  const Cross unshifted = {at_rest, 25000, 0.3};
  EXPECT_NEAR(law({100, 523.15, 0}) / unshifted({100}), 1, 1e-12);
  // 100 MPa: T_s rises by 15 K, and so does A_2.
  EXPECT_NEAR(law({0, 523.15, 1e8}) / (4e12 * std::exp(-28 * 245 / (66.6 + 245))), 1, 1e-12);
  EXPECT_LT(law({100, 533.15, 0}), law({100, 523.15, 0}));
  EXPECT_GT(law({100, 523.15, 1e7}), law({100, 523.15, 0}));
}

TEST(Viscosity, CrossWlfStaysFiniteInTheSolid) {
  const CrossWlf law = {25000, 0.3, 4e12, 263.15, 0, 28, 51.6};
  for (const double temperature : {263.15, 211.55, 211.0, 100.0, 0.0}) EXPECT_EQ(law({0, temperature}), 4e12);
}

TEST(ViscosityLaws, AreMadeByName) {
  const auto law = make_viscosity_law("cross", std::vector<double>{1000, 25000, 0.3});
  EXPECT_NEAR(law->at({25}), 500, 1e-12);
  std::vector<double> viscosities(3);
  law->evaluate(std::vector<double>{0, 25, 1e3}, {}, {}, viscosities);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(viscosities[i], law->at({std::vector<double>{0, 25, 1e3}[i]}));
  EXPECT_THROW((void)make_viscosity_law("cross", std::vector<double>{1000, 25000, 3}), InputError);
  try {
    (void)make_viscosity_law("careau", {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "there is no viscosity law 'careau': did you mean 'carreau'?");
  }
}

}  // namespace
}  // namespace fiberfate
