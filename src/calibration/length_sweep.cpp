// Finds the best value of a swept parameter.
#include "calibration/length_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "base/rising.hpp"
#include "calibration/natural_spline.hpp"

namespace fiberfate {
namespace {

constexpr int points_between = 200;  // at which errors are looked at between two values of the sweep

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

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
    for (std::size_t i = 0; i < lengths_.size(); ++i)
      sum += std::abs(predicted(i, place) / mean_of(lengths_[i].measured) - 1);
    return 100 * sum / static_cast<double>(lengths_.size());
  }
  /// Sums the squares of all samples' errors, relative to the means of their places: a sample's own length in
  /// the denominator would weigh short ones more and lengthen the fit.
  [[nodiscard]] double squares(double place) const {
    double sum = 0;
    for (std::size_t i = 0; i < lengths_.size(); ++i)
      for (const double one : lengths_[i].measured)
        sum += std::pow((predicted(i, place) - one) / mean_of(lengths_[i].measured), 2);
    return sum;
  }
  [[nodiscard]] std::size_t samples() const {
    std::size_t count = 0;
    for (const SweptLength& one : lengths_) count += one.measured.size();
    return count;
  }
  /// Sums the squared slopes of the logarithms of all samples' lengths.
  [[nodiscard]] double information(double place) const {
    constexpr double step = 1e-3;
    double sum = 0;
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      const double slope = (splines_[i].at(place + step) - splines_[i].at(place - step)) / (2 * step);
      sum += static_cast<double>(lengths_[i].measured.size()) * slope * slope;
    }
    return sum;
  }

 private:
  [[nodiscard]] double predicted(std::size_t i, double place) const {
    return std::exp(splines_[i].at(place));
  }
  const std::vector<SweptLength>& lengths_;
  std::vector<NaturalSpline> splines_;
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

void require_sound(const std::vector<double>& values, const std::vector<SweptLength>& lengths) {
  require_numbers("values", values, any_finite);
  if (values.size() < 3 || !are_rising(values))
    throw InputError("the values of the sweep do not rise, or are fewer than three",
                     "give three rising values or more");
  if (lengths.empty())
    throw InputError("no length was measured", "give what was measured at one place at least");
  for (const SweptLength& one : lengths) {
    if (one.measured.empty()) throw InputError("a place has no measured length", "leave the place out");
    require_numbers("measured", one.measured, positive);
    require_same_size("predicted", one.predicted.size(), values.size());
    require_numbers("predicted", one.predicted, positive);
  }
}

}  // namespace

SweepOutcome evaluate_sweep(const std::vector<double>& values, const std::vector<SweptLength>& lengths) {
  require_sound(values, lengths);
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
  const double smooth = least_place(places, [&](double place) { return errors.squares(place); });
  const double freedom = std::max(1.0, static_cast<double>(errors.samples()) - 1);
  outcome.least_squares_value = value_at(smooth);
  outcome.least_squares_error = std::sqrt(errors.squares(smooth) / freedom);
  outcome.standard_error = outcome.least_squares_error / std::sqrt(errors.information(smooth));
  return outcome;
}

}  // namespace fiberfate
