// Sums moments of measured directions and resamples them.
#include "microstructure/orientation_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "microstructure/bootstrap.hpp"

namespace fiberfate {
namespace {

void require_usable(const MeasuredDirections& fibers) {
  if (fibers.directions.empty())
    throw InputError("the list of fibers is empty", "give at least one direction");
  if (!fibers.weights.empty() && fibers.weights.size() != fibers.directions.size())
    throw InputError(
        fmt::format("there are {} weights for {} fibers", fibers.weights.size(), fibers.directions.size()),
        "give one weight a fiber, or none");
  double sum = fibers.weights.empty() ? 1 : 0;
  for (std::size_t i = 0; i < fibers.directions.size(); ++i) {
    const double size = fibers.directions[i].norm();
    if (!(size > 0) || !std::isfinite(size))
      throw InputError(fmt::format("fiber {} has no direction", i + 1), "remove it from the list");
    if (fibers.weights.empty()) continue;
    if (!(fibers.weights[i] >= 0) || !std::isfinite(fibers.weights[i]))
      throw InputError(fmt::format("fiber {} has the weight {}", i + 1, fibers.weights[i]),
                       "weights are not negative");
    sum += fibers.weights[i];
  }
  if (!(sum > 0)) throw InputError("all weights are zero", "give at least one fiber a weight");
}

/// Sums w p p with each fiber counted `counts` times (once when empty).
Mat3 counted_moment(const MeasuredDirections& fibers, const std::vector<int>& counts) {
  Mat3 sum = Mat3::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < fibers.directions.size(); ++i) {
    const double weight = (fibers.weights.empty() ? 1 : fibers.weights[i]) * (counts.empty() ? 1 : counts[i]);
    const Vec3 p = fibers.directions[i].normalized();
    sum += weight * p * p.transpose();
    weights += weight;
  }
  return weights > 0 ? Mat3(sum / weights) : sum;
}

}  // namespace

Vec3 direction_of(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

MeasuredDirections corrected_for_cut(const MeasuredDirections& measured, const Vec3& normal,
                                     double aspect_ratio) {
  require_usable(measured);
  if (!(normal.norm() > 0) || !normal.allFinite())
    throw InputError("the normal of the cut has no direction", "give a vector across the cut");
  if (!(aspect_ratio >= 1))
    throw InputError(fmt::format("an aspect ratio of {:g} is impossible on a cut", aspect_ratio),
                     "give length over diameter, at least 1");
  const Vec3 across = normal.normalized();
  MeasuredDirections corrected = measured;
  corrected.weights.resize(measured.directions.size());
  for (std::size_t i = 0; i < measured.directions.size(); ++i) {
    const double met = std::max(std::abs(measured.directions[i].normalized().dot(across)), 1 / aspect_ratio);
    corrected.weights[i] = (measured.weights.empty() ? 1 : measured.weights[i]) / met;
  }
  return corrected;
}

Mat3 second_moment(const MeasuredDirections& fibers) {
  require_usable(fibers);
  return counted_moment(fibers, {});
}

Mat6 fourth_moment(const MeasuredDirections& fibers) {
  require_usable(fibers);
  Mat6 sum = Mat6::Zero();
  double weights = 0;
  for (std::size_t i = 0; i < fibers.directions.size(); ++i) {
    const double weight = fibers.weights.empty() ? 1 : fibers.weights[i];
    sum += weight * fourth_power(fibers.directions[i].normalized());
    weights += weight;
  }
  return sum / weights;
}

OrientationInterval bootstrap_second_moment(const MeasuredDirections& fibers, const Resampling& resampling) {
  OrientationInterval interval;
  interval.estimate = second_moment(fibers);
  std::vector<std::vector<double>> components(6);
  visit_samples(fibers.directions.size(), resampling, [&](const std::vector<int>& counts) {
    const Vec6 moment = to_components(counted_moment(fibers, counts));
    for (std::size_t m = 0; m < 6; ++m) components[m].push_back(moment[static_cast<int>(m)]);
  });
  Vec6 lower, upper;
  const Vec6 estimate = to_components(interval.estimate);
  for (int m = 0; m < 6; ++m) {
    const Interval one = percentile_interval(estimate[m], components[m], resampling.level);
    lower[m] = one.lower;
    upper[m] = one.upper;
  }
  interval.lower = to_matrix(lower);
  interval.upper = to_matrix(upper);
  return interval;
}

}  // namespace fiberfate
