// Searches the points of a profile.
#include "calibration/profile_walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

#include "base/random.hpp"

namespace fiberfate {
namespace {

/// Rounds of settle_branches: a branch spreads from one neighbour to the next in each.
constexpr int most_rounds = 3;
/// Share by which a minimum must be lower to be another one, not the same found less precisely.
constexpr double lower_by = 1e-7;
/// Places from which explore searches, and the seed with which they are drawn.
constexpr std::uint32_t drawn_places = 6;
constexpr std::uint64_t drawing_seed = 7;
/// Relative difference of chi^2, and distance in coordinates of order one, that make two minima.
constexpr double other_minimum = 1e-5, other_place = 1e-2;

}  // namespace

bool are_distinct(const ProfilePoint& one, const ProfilePoint& other) {
  if (!std::isfinite(one.chi_square) || !std::isfinite(other.chi_square)) return false;
  const double lower = std::min(one.chi_square, other.chi_square);
  if (!(std::abs(one.chi_square - other.chi_square) > other_minimum * lower)) return false;
  double apart = 0;
  for (std::size_t i = 0; i < one.others.size(); ++i)
    apart = std::max(apart, std::abs(one.others[i] - other.others[i]));
  return apart > other_place;
}

ProfileWalk::ProfileWalk(const WeightedResiduals& residuals, std::size_t coordinate, std::vector<double> best,
                         int most_iterations)
    : residuals_(residuals),
      coordinate_(coordinate),
      best_(std::move(best)),
      most_iterations_(most_iterations),
      best_others_(best_) {
  best_others_.erase(best_others_.begin() + static_cast<std::ptrdiff_t>(coordinate_));
  neighbour_ = best_others_;
}

void ProfileWalk::begin_at_best() {
  neighbour_ = best_others_;
}

ProfilePoint ProfileWalk::search(double held, const std::vector<double>& others) const {
  const LeastSquares problem = residuals_.pose_without(coordinate_, held, most_iterations_);
  if (!others.empty()) {
    LeastSquaresMinimum minimum = minimise(problem, others);
    return {minimum.sum_of_squares, std::move(minimum.position)};
  }
  std::vector<double> residuals(problem.residual_count);
  if (!problem.residuals({}, residuals)) return {std::numeric_limits<double>::infinity(), {}};
  double chi_square = 0;
  for (const double residual : residuals) chi_square += residual * residual;
  return {chi_square, {}};
}

bool ProfileWalk::improve(double held, const std::vector<double>& others) {
  ProfilePoint found = search(held, others);
  ProfilePoint& known = points_[held];
  found_several_ |= are_distinct(found, known);
  if (!(found.chi_square < known.chi_square * (1 - lower_by))) return false;
  known = std::move(found);
  return true;
}

double ProfileWalk::at(double held) {
  const auto known = points_.find(held);
  if (known != points_.end()) return known->second.chi_square;
  points_[held] = search(held, neighbour_);
  if (neighbour_ != best_others_) improve(held, best_others_);
  const ProfilePoint& point = points_[held];
  if (std::isfinite(point.chi_square)) neighbour_ = point.others;
  return point.chi_square;
}

double ProfileWalk::explore(double held) {
  at(held);
  if (best_others_.empty()) return points_[held].chi_square;
  const LeastSquares problem = residuals_.pose_without(coordinate_, held, most_iterations_);
  for (std::uint32_t place = 0; place < drawn_places; ++place) {
    std::vector<double> others = best_others_;
    for (std::size_t i = 0; i < others.size(); ++i) {
      const double low = std::isfinite(problem.lower[i]) ? problem.lower[i] : others[i] - 1;
      const double high = std::isfinite(problem.upper[i]) ? problem.upper[i] : others[i] + 1;
      others[i] = std::lerp(
          low, high, uniform(drawing_seed, RandomStream::noise, {place, static_cast<std::uint32_t>(i)}));
    }
    improve(held, others);
  }
  const ProfilePoint& point = points_[held];
  if (std::isfinite(point.chi_square)) neighbour_ = point.others;
  return point.chi_square;
}

void ProfileWalk::settle_branches() {
  if (best_others_.empty()) return;
  for (int round = 0; round < most_rounds; ++round) {
    bool changed = false;
    for (auto here = points_.begin(); here != points_.end(); ++here) {
      const auto next = std::next(here);
      if (next == points_.end()) break;
      if (!std::isfinite(here->second.chi_square) || !std::isfinite(next->second.chi_square)) continue;
      changed |= improve(next->first, here->second.others);
      changed |= improve(here->first, next->second.others);
    }
    if (!changed) return;
  }
}

std::vector<double> ProfileWalk::position(double held) const {
  std::vector<double> whole = points_.at(held).others;
  whole.insert(whole.begin() + static_cast<std::ptrdiff_t>(coordinate_), held);
  return whole;
}

}  // namespace fiberfate
