// Computes orientation tensors and their confidence intervals from lists of measured fibers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Makes p = (sin theta cos phi, sin theta sin phi, cos theta) from angles in radians; theta from axis 3, phi
/// from axis 1 towards axis 2.
[[nodiscard]] Vec3 direction_of(double theta, double phi);

/// Holds measured fibers: directions of any length but zero, and what each counts for (its length, or 1/cos
/// of its angle to a cut's normal; empty: all alike).
struct MeasuredDirections {
  std::vector<Vec3> directions;
  std::vector<double> weights = {};
};

/// A2 = sum w p p / sum w. Raises InputError for an empty list, a zero or non-finite direction, a negative
/// weight.
[[nodiscard]] Mat3 second_moment(const MeasuredDirections& fibers);
/// A4 = sum w p p p p / sum w, components [ij][kl]; raises as second_moment.
[[nodiscard]] Mat6 fourth_moment(const MeasuredDirections& fibers);

/// Holds A2 and the limits of each of its components.
struct OrientationInterval {
  Mat3 estimate = Mat3::Zero();
  Mat3 lower = Mat3::Zero();
  Mat3 upper = Mat3::Zero();
};

/// Finds percentile-bootstrap intervals of A2 that hold with probability `level` (0 to 1) each, from
/// `resamples` draws with replacement; the same seed gives the same intervals. Source: Efron, Ann. Stat. 7, 1
/// (1979).
[[nodiscard]] OrientationInterval bootstrap_second_moment(const MeasuredDirections& fibers, double level,
                                                          int resamples, std::uint64_t seed);

}  // namespace fiberfate
