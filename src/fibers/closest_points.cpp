// Finds the closest points of two rods.
#include "fibers/closest_points.hpp"

#include <algorithm>

namespace fiberfate {
namespace {

// Squared sine of the angle below which two segments count as parallel: there the optimum of the lines is
// round-off.
constexpr double parallel_sine_squared = 1e-12;

double clamp_to_unit(double value) {
  return std::clamp(value, 0.0, 1.0);
}

/// Place on a segment of squared length `squared` whose unclamped optimum is moment / squared; 0 on a point.
double place(double moment, double squared) {
  return squared > 0 ? clamp_to_unit(moment / squared) : 0.0;
}

/// Middle of the part of the first segment that the second, parallel one lies alongside; its nearer end where
/// none is.
double middle_of_overlap(const Vec3& direction, const Vec3& to_begin, const Vec3& to_end) {
  const double squared = direction.squaredNorm();
  const double from = place(direction.dot(to_begin), squared);
  const double to = place(direction.dot(to_end), squared);
  return 0.5 * (from + to);
}

}  // namespace

ClosestPoints closest_points(const Segment& first, const Segment& second) {
  const Vec3 along_first = first.end - first.begin;
  const Vec3 along_second = second.end - second.begin;
  const Vec3 offset = first.begin - second.begin;
  const double squared_first = along_first.squaredNorm();
  const double squared_second = along_second.squaredNorm();
  const double product = along_first.dot(along_second);
  const double moment_first = -along_first.dot(offset);
  const double moment_second = along_second.dot(offset);
  const double determinant = squared_first * squared_second - product * product;

  ClosestPoints closest;
  if (determinant <= parallel_sine_squared * squared_first * squared_second) {
    closest.s = middle_of_overlap(along_first, -offset, along_second - offset);
  } else {
    closest.s = clamp_to_unit((moment_first * squared_second + product * moment_second) / determinant);
  }
  closest.t = place(product * closest.s + moment_second, squared_second);
  closest.s = place(product * closest.t + moment_first, squared_first);
  closest.separation = offset + closest.s * along_first - closest.t * along_second;
  closest.distance = closest.separation.norm();
  return closest;
}

}  // namespace fiberfate
