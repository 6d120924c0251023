// Measures a population of fibers: lengths, orientation, curvature.
#include "fibers/observables.hpp"

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "base/rising.hpp"

namespace fiberfate {
namespace {

/// Calls visit(direction, weight) for every rod; the weights sum to one.
template <class Visit>
void visit_rods(const FiberState& state, Weighting weighting, const Visit& visit) {
  double total = 0;
  for (const FiberIndex fiber : state.fibers())
    total += weighting == Weighting::length ? fiber_length(state, fiber) : 1.0;
  for (const FiberIndex fiber : state.fibers()) {
    const double share = weighting == Weighting::length ? total : total * fiber_length(state, fiber);
    for (const RodIndex rod : state.rods(fiber))
      visit(state.axis(rod).normalized(), state.rod_length[rod] / share);
  }
}

/// Calls visit(radius) for every hinge, in order of nodes.
template <class Visit>
void visit_hinges(const FiberState& state, const Visit& visit) {
  for (const FiberIndex fiber : state.fibers()) {
    for (const NodeIndex hinge : state.hinges(fiber)) visit(hinge_radius(state, hinge));
  }
}

}  // namespace

MeanLengths mean_lengths(const FiberState& state) {
  double sum = 0;
  double sum_of_squares = 0;
  for (const FiberIndex fiber : state.fibers()) {
    const double length = fiber_length(state, fiber);
    sum += length;
    sum_of_squares += length * length;
  }
  if (state.fiber_count() == 0) return {};
  return {sum / state.fiber_count(), sum_of_squares / sum};
}

Mat3 orientation_tensor(const FiberState& state, Weighting weighting) {
  Mat3 tensor = Mat3::Zero();
  visit_rods(state, weighting, [&](const Vec3& p, double weight) { tensor += weight * (p * p.transpose()); });
  return tensor;
}

Eigen::Matrix<double, 6, 6> orientation_tensor4(const FiberState& state, Weighting weighting) {
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> tensor = Eigen::Matrix<double, 6, 6>::Zero();
  visit_rods(state, weighting, [&](const Vec3& p, double weight) {
    Vec6 dyad;
    dyad << p[0] * p[0], p[1] * p[1], p[2] * p[2], p[1] * p[2], p[2] * p[0], p[0] * p[1];
    tensor += weight * (dyad * dyad.transpose());
  });
  return tensor;
}

std::vector<double> length_histogram(const FiberState& state, std::span<const double> edges,
                                     Weighting weighting) {
  if (edges.size() < 2 || !are_rising(edges))
    throw InputError("the edges of the bins do not rise, or are fewer than two", "give rising edges");
  std::vector<double> bins(edges.size() - 1, 0.0);
  for (const FiberIndex fiber : state.fibers()) {
    const double length = fiber_length(state, fiber);
    if (length < edges.front() || length > edges.back()) continue;
    const auto above = std::upper_bound(edges.begin(), edges.end(), length);
    const auto bin = std::min(above - edges.begin(), std::ssize(bins)) - 1;
    bins[bin] += weighting == Weighting::length ? length : 1.0;
  }
  return bins;
}

std::vector<double> hinge_radii(const FiberState& state) {
  std::vector<double> radii;
  radii.reserve(state.position.size());
  visit_hinges(state, [&](double radius) { radii.push_back(radius); });
  return radii;
}

double minimum_radius(const FiberState& state) {
  double smallest = std::numeric_limits<double>::infinity();
  visit_hinges(state, [&](double radius) { smallest = std::min(smallest, radius); });
  return smallest;
}

std::int64_t count_hinges(const FiberState& state, double low, double high) {
  std::int64_t count = 0;
  visit_hinges(state, [&](double radius) { count += radius >= low && radius < high ? 1 : 0; });
  return count;
}

}  // namespace fiberfate
