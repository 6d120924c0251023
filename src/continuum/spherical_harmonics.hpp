// Builds the matrices of multiplication and rotation in real spherical harmonics of even degree.
#pragma once

#include <Eigen/SparseCore>
#include <array>

#include "base/vector.hpp"

namespace fiberfate {

/// Operators on the real orthonormal harmonics of degree 0, 2, …, `degree`, ordered by degree l and
/// within it by m = -l … l: m > 0 goes with cos(m phi), m < 0 with sin(|m| phi).
struct HarmonicOperators {
  std::array<Eigen::SparseMatrix<double>, 3> rotation;  ///< R = p × grad
  std::array<Eigen::SparseMatrix<double>, 6> product;   ///< multiplication by p_i p_j: 11, 22, 33, 23, 31, 12
  Eigen::VectorXd laplacian;                            ///< its diagonal, -l (l + 1)
};

/// Builds the operators for an even degree. The product is exact within the space: what leaves it upwards is
/// dropped.
[[nodiscard]] HarmonicOperators harmonic_operators(int degree);

/// Evaluates all harmonics of even degree in one direction, in the order of the operators.
[[nodiscard]] Eigen::VectorXd harmonics_at(const Vec3& direction, int degree);

}  // namespace fiberfate
