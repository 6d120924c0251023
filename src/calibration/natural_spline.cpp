// Solves for the bends of a natural cubic spline and evaluates it.
#include "calibration/natural_spline.hpp"

#include <algorithm>
#include <functional>

#include "base/error.hpp"
#include "base/number_checks.hpp"

namespace fiberfate {

NaturalSpline::NaturalSpline(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), bend_(x_.size(), 0.0) {
  require_same_size("y", y_.size(), x_.size());
  require_numbers("x", x_, any_finite);
  require_numbers("y", y_, any_finite);
  if (x_.size() < 2 || std::ranges::adjacent_find(x_, std::greater_equal<>()) != x_.end())
    throw InputError("the points of a spline do not rise", "give at least two in rising order");
  const std::size_t n = x_.size();
  std::vector<double> upper(n, 0.0), right(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = x_[i] - x_[i - 1], after = x_[i + 1] - x_[i];
    const double pivot = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    const double jump = 6 * ((y_[i + 1] - y_[i]) / after - (y_[i] - y_[i - 1]) / before);
    right[i] = (jump - before * right[i - 1]) / pivot;
  }
  for (std::size_t i = n - 2; i > 0; --i) bend_[i] = right[i] - upper[i] * bend_[i + 1];
}

double NaturalSpline::at(double x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const std::size_t i = above - x_.begin();
  const double width = x_[i] - x_[i - 1], a = (x_[i] - x) / width, b = 1 - a;
  return a * y_[i - 1] + b * y_[i] +
         ((a * a * a - a) * bend_[i - 1] + (b * b * b - b) * bend_[i]) * width * width / 6;
}

}  // namespace fiberfate
