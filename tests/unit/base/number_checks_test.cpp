// Tests that impossible numbers are refused with the path of the parameter.
#include "base/number_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {
namespace {

InputProblem problem_of(const auto& check) {
  try {
    check();
  } catch (const InputError& error) {
    return error.problems().front();
  }
  return {};
}

TEST(NumberChecks, NameTheParameterAndWhatItMayBe) {
  const InputProblem problem = problem_of([] { require_number("law.C_I", -0.5, not_negative); });
  EXPECT_EQ(problem.key, "law.C_I");
  EXPECT_EQ(problem.message(), "law.C_I = -0.5: out of range: give a finite number of at least 0");
  EXPECT_EQ(problem_of([] { require_number("x", NAN, any_finite); }).message(),
            "x = nan: not a number: give a finite number");
  EXPECT_EQ(problem_of([] { require_number("x", INFINITY, positive); }).message(),
            "x = inf: not finite: give a finite number above 0");
  EXPECT_EQ(problem_of([] { require_number("x", 2, {.lower = 0, .upper = 1}); }).message(),
            "x = 2: out of range: give a number from 0 to 1");
}

TEST(NumberChecks, NameThePlaceInAnArray) {
  std::vector<double> rates(20, 1.0);
  EXPECT_NO_THROW(require_numbers("rate", rates, positive));
  rates[17] = 0;
  EXPECT_EQ(problem_of([&] { require_numbers("rate", rates, positive); }).key, "rate[17]");
  EXPECT_NO_THROW(require_numbers("rate", rates, not_negative));
  EXPECT_THROW(require_same_size("rate", 19, 20), InputError);
}

}  // namespace
}  // namespace fiberfate
