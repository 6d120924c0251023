// Tests the reading of quantities with units.
#include "base/units.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

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

TEST(Units, TellsFactors) {
  EXPECT_DOUBLE_EQ(unit_factor("mm", "m"), 1e-3);
  EXPECT_DOUBLE_EQ(unit_factor("degC", "K"), 1.0);
  EXPECT_THROW(static_cast<void>(unit_factor("mm", "s")), std::invalid_argument);
}

}  // namespace
}  // namespace fiberfate
