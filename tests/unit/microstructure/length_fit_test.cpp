// Checks fits of laws of lengths against their definitions, and the distributions that are read from lists.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "microstructure/length_distribution.hpp"
#include "microstructure/length_fit.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t many = 20000;

/// A stratified sample is as near to its law as a list of so many lengths can be.
MeasuredLengths sample_of(const LengthLaw& law) {
  return {sample_lengths(law, {.count = many, .seed = 3})};
}

TEST(LengthFit, FindsTheLawThatASampleCameFrom) {
  const MeasuredLengths weibull = sample_of(WeibullLengths{1e-3, 1.6e-3});
  const auto found = fit_lengths(LengthFamily::weibull, weibull);
  ASSERT_TRUE(found);
  EXPECT_NEAR(number_average(*found), 1e-3, 2e-6);
  EXPECT_NEAR(weight_average(*found), 1.6e-3, 4e-6);
  const MeasuredLengths log_normal = sample_of(LogNormalLengths{1e-3, 1.6e-3});
  const auto other = fit_lengths(LengthFamily::log_normal, log_normal);
  ASSERT_TRUE(other);
  EXPECT_NEAR(number_average(*other), 1e-3, 3e-6);
  EXPECT_NEAR(weight_average(*other), 1.6e-3, 8e-6);
  EXPECT_NEAR(other->shape, std::sqrt(std::log(1.6)), 1e-3);
}

TEST(LengthFit, TellsTheRightLawByItsDistance) {
  const MeasuredLengths list = sample_of(WeibullLengths{1e-3, 1.6e-3});
  const CumulativeLengths steps(list, LengthWeight::number);
  EXPECT_LT(steps.distance(*fit_lengths(LengthFamily::weibull, list)), 0.002);
  EXPECT_GT(steps.distance(*fit_lengths(LengthFamily::log_normal, list)), 0.02);
}

TEST(LengthFit, HasAnExponentialAsTheWeibullLawOfExponentOne) {
  // P(L < x) = 1 − exp(−x); by length 1 − (1 + x) exp(−x).
  const FittedLengths law{LengthFamily::weibull, 1, 1};
  for (const double x : {1e-6, 0.1, 1.0, 5.0, 60.0, 800.0}) {
    EXPECT_NEAR(number_share_below(law, x), -std::expm1(-x), 1e-15);
    EXPECT_NEAR(length_share_below(law, x), 1 - (1 + x) * std::exp(-x), 2e-15);
  }
  EXPECT_EQ(length_share_below(law, 0), 0);
  EXPECT_NEAR(number_average(law), 1, 1e-15);
  EXPECT_NEAR(weight_average(law), 2, 1e-15);
}

TEST(LengthFit, SharesByLengthAreTheFirstMomentOfSharesByNumber) {
  for (const FittedLengths& law : {FittedLengths{LengthFamily::weibull, 1.4, 2e-3},
                                   FittedLengths{LengthFamily::log_normal, 0.7, 2e-3}}) {
    double moment = 0;
    const double step = 1e-6, end = 3e-3;
    for (double at = 0; at < end - 0.5 * step; at += step)
      moment += (at + 0.5 * step) * (number_share_below(law, at + step) - number_share_below(law, at));
    EXPECT_NEAR(moment / number_average(law), length_share_below(law, end), 1e-6);
  }
}

TEST(LengthFit, WeighsFibersByTheirNumbers) {
  const auto repeated = fit_lengths(LengthFamily::weibull, {{1, 1, 1, 2, 3}});
  const auto counted = fit_lengths(LengthFamily::weibull, {{1, 2, 3}, {3, 1, 1}});
  EXPECT_NEAR(repeated->shape, counted->shape, 1e-12);
  EXPECT_NEAR(repeated->scale, counted->scale, 1e-12);
}

TEST(LengthFit, FitsNothingToLengthsThatAreAlike) {
  for (const LengthFamily family : {LengthFamily::weibull, LengthFamily::log_normal}) {
    EXPECT_FALSE(fit_lengths(family, {{1e-3, 1e-3, 1e-3}}));
    EXPECT_FALSE(fit_lengths(family, {{1e-3}}));
    EXPECT_THROW((void)fit_lengths(family, MeasuredLengths{}), InputError);
  }
}

TEST(CumulativeLengths, StepsAtEveryLength) {
  const MeasuredLengths list{{4, 1, 1, 2}};
  const CumulativeLengths by_number(list, LengthWeight::number), by_length(list, LengthWeight::length);
  EXPECT_EQ(by_number.share_up_to(0.5), 0);
  EXPECT_EQ(by_number.share_up_to(1), 0.5);
  EXPECT_EQ(by_number.share_up_to(3), 0.75);
  EXPECT_EQ(by_length.share_up_to(2), 0.5);
  EXPECT_EQ(by_number.quantile(0.5), 1);
  EXPECT_EQ(by_number.quantile(0.51), 2);
  EXPECT_EQ(by_length.quantile(0.9), 4);
}

}  // namespace
}  // namespace fiberfate
