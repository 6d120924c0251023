// Finds the best value of a swept parameter.
#include "app/studies/molding_sweep.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fiberfate {
namespace {

constexpr int points_between = 200;  // at which errors are looked at between two values of the sweep

/// Interpolates by a natural cubic spline.
class Spline {
 public:
  Spline(const std::vector<double>& x, std::vector<double> y)
      : x_(x), y_(std::move(y)), bend_(x.size(), 0.0) {
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
  [[nodiscard]] double at(double x) const {
    const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
    const auto i = static_cast<std::size_t>(above - x_.begin());
    const double width = x_[i] - x_[i - 1], a = (x_[i] - x) / width, b = 1 - a;
    return a * y_[i - 1] + b * y_[i] +
           ((a * a * a - a) * bend_[i - 1] + (b * b * b - b) * bend_[i]) * width * width / 6;
  }

 private:
  const std::vector<double>& x_;
  std::vector<double> y_, bend_;
};

/// Evaluates both errors at any place of the sweep.
class SweepErrors {
 public:
  SweepErrors(const std::vector<double>& places, const std::vector<SweptLength>& lengths)
      : lengths_(lengths) {
    for (const SweptLength& one : lengths) {
      std::vector<double> logarithms;
      for (const double length : one.predicted) logarithms.push_back(std::log(length));
      splines_.emplace_back(places, std::move(logarithms));
    }
  }
  [[nodiscard]] double average_percent(double place) const {
    double sum = 0;
    for (std::size_t i = 0; i < lengths_.size(); ++i) sum += std::abs(relative(i, place));
    return 100 * sum / static_cast<double>(lengths_.size());
  }
  [[nodiscard]] double mean_square(double place) const {
    double sum = 0;
    for (std::size_t i = 0; i < lengths_.size(); ++i) sum += relative(i, place) * relative(i, place);
    return sum / static_cast<double>(lengths_.size());
  }
  /// Sums the squared slopes of the logarithms of all lengths.
  [[nodiscard]] double information(double place) const {
    constexpr double step = 1e-3;
    double sum = 0;
    for (const Spline& spline : splines_) {
      const double slope = (spline.at(place + step) - spline.at(place - step)) / (2 * step);
      sum += slope * slope;
    }
    return sum;
  }

 private:
  [[nodiscard]] double relative(std::size_t i, double place) const {
    return std::exp(splines_[i].at(place)) / lengths_[i].measured - 1;
  }
  const std::vector<SweptLength>& lengths_;
  std::vector<Spline> splines_;
};

/// Finds the least of a function on a fine grid between the places.
template <class Function>
double least_place(const std::vector<double>& places, const Function& function) {
  double best = places.front(), least = function(best);
  for (std::size_t i = 0; i + 1 < places.size(); ++i)
    for (int k = 1; k <= points_between; ++k) {
      const double place = std::lerp(places[i], places[i + 1], static_cast<double>(k) / points_between);
      const double value = function(place);
      if (value < least) {
        least = value;
        best = place;
      }
    }
  return best;
}

}  // namespace

SweepOutcome evaluate_sweep(const std::vector<double>& values, const std::vector<SweptLength>& lengths) {
  assert(values.size() >= 3 && !lengths.empty());
  const bool logarithmic = values.front() > 0;
  std::vector<double> places = values;
  if (logarithmic)
    for (double& place : places) place = std::log(place);
  const auto value_at = [logarithmic](double place) { return logarithmic ? std::exp(place) : place; };
  const SweepErrors errors(places, lengths);
  SweepOutcome outcome;
  for (const double place : places) outcome.errors.push_back(errors.average_percent(place));
  const double best = least_place(places, [&](double place) { return errors.average_percent(place); });
  outcome.best_value = value_at(best);
  outcome.best_error = errors.average_percent(best);
  const double smooth = least_place(places, [&](double place) { return errors.mean_square(place); });
  const auto count = static_cast<double>(lengths.size());
  const double freedom = std::max(1.0, count - 1);
  outcome.least_squares_value = value_at(smooth);
  outcome.least_squares_error = std::sqrt(errors.mean_square(smooth) * count / freedom);
  outcome.standard_error = outcome.least_squares_error / std::sqrt(errors.information(smooth));
  return outcome;
}

}  // namespace fiberfate
