// Computes orientation tensors and their confidence intervals from lists of measured fibers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"
#include "microstructure/bootstrap.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Makes p = (sin theta cos phi, sin theta sin phi, cos theta) from angles in radians; theta from axis 3, phi
/// from axis 1 towards axis 2.
[[nodiscard]] Vec3 direction_of(double theta, double phi);

/// Measured fibers: directions of any length but zero, and what each counts for (its length, say;
/// empty: all alike).
struct MeasuredDirections {
  std::vector<Vec3> directions;
  std::vector<double> weights = {};
};

/// Weighs fibers that were found on a plane cut so that they stand for the volume: a cut of normal n meets
/// fibers of length L in proportion to L |p·n|, and those that lie in it in proportion to their diameter D,
/// so each counts w/max(|p·n|, D/L). Presumes straight fibers of one aspect ratio L/D. Raises InputError for
/// a zero normal or an aspect ratio below 1. Source: Bay, Tucker, Polym. Eng. Sci. 32, 240 (1992).
[[nodiscard]] MeasuredDirections corrected_for_cut(const MeasuredDirections& measured, const Vec3& normal,
                                                   double aspect_ratio);

/// A2 = sum w p p / sum w. Raises InputError for an empty list, a zero or non-finite direction, a negative
/// weight.
[[nodiscard]] Mat3 second_moment(const MeasuredDirections& fibers);
/// A4 = sum w p p p p / sum w, components [ij][kl]; raises as second_moment.
[[nodiscard]] Mat6 fourth_moment(const MeasuredDirections& fibers);

/// A2 and the limits of each of its components.
struct OrientationInterval {
  Mat3 estimate = Mat3::Zero();
  Mat3 lower = Mat3::Zero();
  Mat3 upper = Mat3::Zero();
};

/// Finds percentile-bootstrap intervals of A2 from draws with replacement; the same seed gives the same
/// intervals. Source: Efron, Ann. Stat. 7, 1 (1979).
[[nodiscard]] OrientationInterval bootstrap_second_moment(const MeasuredDirections& fibers,
                                                          const Resampling& resampling);

}  // namespace fiberfate
