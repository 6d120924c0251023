// When the outputs of a run are due.
#include "results/output_schedule.hpp"

#include <algorithm>
#include <cmath>

namespace fiberfate {
namespace {

constexpr double oneness = 1e-6;  // times nearer than this share of the interval are the same time

}  // namespace

double OutputSchedule::next(double time) const {
  const double beyond = time + oneness * interval;
  double multiple = std::floor(time / interval);
  while (multiple * interval <= beyond) ++multiple;
  double due = multiple * interval;
  for (const double other : others) {
    if (other > beyond) due = std::min(due, snapped(other));
  }
  return due;
}

bool OutputSchedule::includes(double time) const {
  const double slack = oneness * interval;
  if (std::abs(std::round(time / interval) * interval - time) <= slack) return true;
  return std::any_of(others.begin(), others.end(),
                     [&](double other) { return std::abs(other - time) <= slack; });
}

double OutputSchedule::snapped(double time) const {
  const double multiple = std::round(time / interval) * interval;
  return std::abs(multiple - time) <= oneness * interval ? multiple : time;
}

}  // namespace fiberfate
