// Tests the reading of quantities with units.
#include "base/units.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace fiberfate {
namespace {

TEST(Units, ConvertsToSi) {
  EXPECT_DOUBLE_EQ(quantity_in_si("19 um", "m"), 19e-6);
  EXPECT_DOUBLE_EQ(quantity_in_si("73 GPa", "Pa"), 73e9);
  EXPECT_DOUBLE_EQ(quantity_in_si("16.65 1/s", "1/s"), 16.65);
  EXPECT_DOUBLE_EQ(quantity_in_si("200 Pa s", "Pa s"), 200);
  EXPECT_DOUBLE_EQ(quantity_in_si("30 %", "1"), 0.3);
  EXPECT_DOUBLE_EQ(quantity_in_si("200 degC", "K"), 473.15);
  EXPECT_DOUBLE_EQ(quantity_in_si("  +1e-3 ", "m"), 1e-3);
}

TEST(Units, RefusesWhatIsNoQuantityOfThatDimension) {
  EXPECT_THROW(static_cast<void>(quantity_in_si("19 s", "m")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(quantity_in_si("19 parsnips", "m")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(quantity_in_si("nan m", "m")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(quantity_in_si("um", "m")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(quantity_in_si("", "m")), std::invalid_argument);
}

/// Gives what is said about a quantity that is refused.
std::string refusal(const std::string& quantity, const std::string& si_unit) {
  try {
    return fmt::format("{} {}", quantity_in_si(quantity, si_unit), si_unit);
  } catch (const std::invalid_argument& reason) {
    return reason.what();
  }
}

TEST(Units, DoesNotTakeAPeriodForARate) {
  EXPECT_EQ(refusal("20 s", "1/s"), "'s' is the reciprocal of '1/s', and is not converted into it");
  EXPECT_EQ(refusal("50 Hz", "s"), "'Hz' is the reciprocal of 's', and is not converted into it");
  EXPECT_EQ(refusal("50000 1/m", "m"), "'1/m' is the reciprocal of 'm', and is not converted into it");
  EXPECT_EQ(refusal("3 mm", "1/m"), "'mm' is the reciprocal of '1/m', and is not converted into it");
  EXPECT_EQ(refusal("2 K", "1/K"), "'K' is the reciprocal of '1/K', and is not converted into it");
  EXPECT_THROW(static_cast<void>(unit_factor("1/mm", "m")), std::invalid_argument);
  EXPECT_DOUBLE_EQ(quantity_in_si("50 Hz", "1/s"), 50);
  EXPECT_DOUBLE_EQ(quantity_in_si("3 1/min", "1/s"), 0.05);
}

TEST(Units, DoesNotTakeAnglesForNumbers) {
  EXPECT_EQ(refusal("30 rpm", "1/s"), "'rpm' counts turns or angles, and '1/s' does not");
  EXPECT_EQ(refusal("3 rad/s", "1/s"), "'rad/s' counts turns or angles, and '1/s' does not");
  for (const char* angle : {"90 degree", "90 °", "1 rad", "5'", "1 turn", "1 sr"})
    EXPECT_NE(refusal(angle, "1").find("counts turns or angles"), std::string::npos) << angle;
  EXPECT_THROW(static_cast<void>(quantity_in_si("3 dB", "1")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(quantity_in_si("3 lg(re 1 mm)", "m")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(quantity_in_si("3 s since 2001-01-01", "s")), std::invalid_argument);
}

TEST(Units, OffersTheUnitThatWasMeant) {
  EXPECT_NE(refusal("20 C", "K").find("'C' is coulomb: write 'degC'"), std::string::npos);
  EXPECT_NE(refusal("70 F", "K").find("'F' is farad: write 'degF'"), std::string::npos);
  EXPECT_NE(refusal("1.5 GPA", "Pa").find("did you mean 'GPa'?"), std::string::npos);
  EXPECT_DOUBLE_EQ(quantity_in_si("20 °C", "K"), 293.15);
  EXPECT_EQ(refusal("20 s", "K"), "'s' does not have the dimension of 'K'");
}

TEST(Units, ReadsTheSignsThatTextProcessorsPut) {
  EXPECT_DOUBLE_EQ(quantity_in_si("16.65 s⁻¹", "1/s"), 16.65);
  EXPECT_DOUBLE_EQ(quantity_in_si("19\u00A0µm", "m"), 19e-6);       // no-break space, micro sign
  EXPECT_DOUBLE_EQ(quantity_in_si("19\u202F\u03BCm", "m"), 19e-6);  // narrow space, Greek letter
  EXPECT_DOUBLE_EQ(quantity_in_si("\u00A0−5 °C", "K"), 268.15);
  EXPECT_DOUBLE_EQ(quantity_in_si("3 mm²", "m^2"), 3e-6);
  EXPECT_DOUBLE_EQ(quantity_in_si("200 Pa·s", "Pa s"), 200);
  EXPECT_THROW(static_cast<void>(quantity_in_si("10³ um", "m")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(quantity_in_si("10⁻³ m", "m")), std::invalid_argument);
}

TEST(Units, ReadsOneNumberAndNoPartOfOne) {
  EXPECT_NE(refusal("1,5 mm", "m").find("decimal comma"), std::string::npos);
  for (const char* two : {"1 000 um", "2 - 3 mm", "1'000 um", "5 10 um", "2 1e-3 m", "3 1/10 s", "1 2/s"})
    EXPECT_NE(refusal(two, "m").find("two numbers"), std::string::npos) << two;
  EXPECT_THROW(static_cast<void>(quantity_in_si("3 mm @ 5", "m")), std::invalid_argument);
  EXPECT_DOUBLE_EQ(quantity_in_si("2 cm3/s", "m^3/s"), 2e-6);
  EXPECT_DOUBLE_EQ(quantity_in_si("2 1 / s", "1/s"), 2);
  EXPECT_DOUBLE_EQ(quantity_in_si("2 kg m-3", "kg/m^3"), 2);
  EXPECT_DOUBLE_EQ(quantity_in_si("2 W m**-1 K^-1", "W/(m K)"), 2);
}

TEST(Units, TellsFactors) {
  EXPECT_DOUBLE_EQ(unit_factor("mm", "m"), 1e-3);
  EXPECT_DOUBLE_EQ(unit_factor("degC", "K"), 1.0);
  EXPECT_THROW(static_cast<void>(unit_factor("mm", "s")), std::invalid_argument);
}

}  // namespace
}  // namespace fiberfate
