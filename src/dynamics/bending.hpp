// Gives the bending moment at a hinge.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vector.hpp"

namespace fiberfate {

/// Elastic hinge of Euler-Bernoulli beam theory: moment M = E I theta / l̄ with turning angle theta between
/// the rods and l̄ the mean of their lengths, about p_before × p_after. As node forces, apart from parts along
/// the rods that the tensions absorb, with b = p_after − p_before and gamma = (1/l_before, −1/l_before −
/// 1/l_after, 1/l_after):
///   force on node j of the three = −stiffness gamma_j b,   stiffness = (E I / l̄) theta / sin theta
/// Source: thesis (3.10) to (3.12), where alpha is the angle.
struct ElasticHinge {
  double bending_stiffness;  ///< E I, N m²

  /// Returns (E I / l̄) theta / sin theta in N m for the unit vectors of the two rods; theta is capped short
  /// of a fold.
  [[nodiscard]] double operator()(const Vec3& turn, double mean_length) const {
    // |b| = 2 sin(theta/2). A fold (theta = pi) has no finite theta / sin theta; 0.999 is theta = 174.9
    // degrees.
    const double half = std::min(0.5 * turn.norm(), 0.999);
    const double ratio = half < 1e-8 ? 1.0 : std::asin(half) / (half * std::sqrt(1 - half * half));
    return bending_stiffness / mean_length * ratio;
  }
};

}  // namespace fiberfate
