// Fits laws of lengths by maximum likelihood.
#include "microstructure/length_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fiberfate {
namespace {

/// A fit wider or narrower than this tells of lengths that are alike, or of none.
constexpr double least_exponent = 1e-2, largest_exponent = 1e3;

/// Mean of ln(L/unit) over the fibers.
double mean_logarithm(const MeasuredLengths& fibers, double unit) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < fibers.lengths.size(); ++i) {
    sum += number_of(fibers, i) * std::log(fibers.lengths[i] / unit);
    count += number_of(fibers, i);
  }
  return sum / count;
}

/// Sums of (L/longest)^k and of that times ln(L/longest).
struct PowerSums {
  double count = 0, power = 0, power_logarithm = 0;
};

PowerSums power_sums(const MeasuredLengths& fibers, double longest, double exponent) {
  PowerSums sums;
  for (std::size_t i = 0; i < fibers.lengths.size(); ++i) {
    const double logarithm = std::log(fibers.lengths[i] / longest);
    const double power = number_of(fibers, i) * std::exp(exponent * logarithm);
    sums.count += number_of(fibers, i);
    sums.power += power;
    sums.power_logarithm += power * logarithm;
  }
  return sums;
}

/// Bisects the likelihood equation sum L^k ln L / sum L^k − 1/k = mean ln L, whose left side rises with k.
std::optional<FittedLengths> fit_weibull(const MeasuredLengths& fibers) {
  const double longest = std::ranges::max(fibers.lengths);
  const double mean = mean_logarithm(fibers, longest);
  const auto excess = [&](double exponent) {
    const PowerSums sums = power_sums(fibers, longest, exponent);
    return sums.power_logarithm / sums.power - 1 / exponent - mean;
  };
  double low = std::log(least_exponent), high = std::log(largest_exponent);
  if (!(excess(least_exponent) < 0) || !(excess(largest_exponent) > 0)) return {};
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (excess(std::exp(middle)) < 0 ? low : high) = middle;
  }
  const double exponent = std::exp(0.5 * (low + high));
  const PowerSums sums = power_sums(fibers, longest, exponent);
  return FittedLengths{LengthFamily::weibull, exponent,
                       longest * std::pow(sums.power / sums.count, 1 / exponent)};
}

std::optional<FittedLengths> fit_log_normal(const MeasuredLengths& fibers) {
  const double median = std::exp(mean_logarithm(fibers, 1));
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < fibers.lengths.size(); ++i) {
    const double away = std::log(fibers.lengths[i] / median);
    squares += number_of(fibers, i) * away * away;
    count += number_of(fibers, i);
  }
  const double deviation = std::sqrt(squares / count);
  if (!(deviation > 1 / largest_exponent)) return {};
  return FittedLengths{LengthFamily::log_normal, deviation, median};
}

double normal_share_below(double deviations) {
  return 0.5 * std::erfc(-deviations / std::sqrt(2.0));
}

/// The regularised lower incomplete gamma function P(a, x) by its series of positive terms.
double lower_gamma(double a, double x) {
  if (!(x > 0)) return 0;
  constexpr double all_below = 700;  // exp(-x) underflows beyond; for a <= 101, P is 1 there
  if (x > all_below) return 1;
  double term = std::exp(a * std::log(x) - x - std::lgamma(a + 1)), sum = term;
  for (double n = 1; term > 1e-17 * sum; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return std::min(sum, 1.0);
}

}  // namespace

std::optional<FittedLengths> fit_lengths(LengthFamily family, const MeasuredLengths& fibers) {
  static_cast<void>(number_average(fibers));
  return family == LengthFamily::weibull ? fit_weibull(fibers) : fit_log_normal(fibers);
}

double number_average(const FittedLengths& law) {
  if (law.family == LengthFamily::weibull) return law.scale * std::tgamma(1 + 1 / law.shape);
  return law.scale * std::exp(0.5 * law.shape * law.shape);
}

double weight_average(const FittedLengths& law) {
  if (law.family == LengthFamily::weibull)
    return law.scale * std::tgamma(1 + 2 / law.shape) / std::tgamma(1 + 1 / law.shape);
  return law.scale * std::exp(1.5 * law.shape * law.shape);
}

double number_share_below(const FittedLengths& law, double length) {
  if (!(length > 0)) return 0;
  if (law.family == LengthFamily::weibull) return -std::expm1(-std::pow(length / law.scale, law.shape));
  return normal_share_below(std::log(length / law.scale) / law.shape);
}

double length_share_below(const FittedLengths& law, double length) {
  if (!(length > 0)) return 0;
  if (law.family == LengthFamily::weibull)
    return lower_gamma(1 + 1 / law.shape, std::pow(length / law.scale, law.shape));
  return normal_share_below(std::log(length / law.scale) / law.shape - law.shape);
}

CumulativeLengths::CumulativeLengths(const MeasuredLengths& fibers, LengthWeight weight) {
  static_cast<void>(number_average(fibers));
  std::vector<std::size_t> order(fibers.lengths.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&fibers](std::size_t i) { return fibers.lengths[i]; });
  double sum = 0;
  for (const std::size_t i : order) {
    sum += number_of(fibers, i) * (weight == LengthWeight::length ? fibers.lengths[i] : 1);
    lengths_.push_back(fibers.lengths[i]);
    shares_.push_back(sum);
  }
  for (double& share : shares_) share /= sum;
}

double CumulativeLengths::share_up_to(double length) const {
  const auto above = std::ranges::upper_bound(lengths_, length);
  return above == lengths_.begin() ? 0 : shares_[static_cast<std::size_t>(above - lengths_.begin()) - 1];
}

double CumulativeLengths::quantile(double share) const {
  const auto found = std::ranges::lower_bound(shares_, share * (1 - 1e-12));
  return found == shares_.end() ? lengths_.back()
                                : lengths_[static_cast<std::size_t>(found - shares_.begin())];
}

double CumulativeLengths::distance(const FittedLengths& law) const {
  double largest = 0, below = 0;
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    if (i + 1 < lengths_.size() && lengths_[i + 1] == lengths_[i])
      continue;  // the step is at the last of them
    const double expected = number_share_below(law, lengths_[i]);
    largest = std::max({largest, std::abs(expected - below), std::abs(expected - shares_[i])});
    below = shares_[i];
  }
  return largest;
}

}  // namespace fiberfate
