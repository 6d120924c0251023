// The flow that carries fibers at one instant: velocity gradient, and the melt that flows.
#pragma once

#include <cmath>

#include "base/vector.hpp"

namespace fiberfate {

/// The flow at one instant: u(x) = gradient · x.
struct Flow {
  Mat3 gradient = Mat3::Zero();  ///< kappa_ij = d u_i / d x_j, 1/s
  double viscosity = 0;          ///< of the matrix, Pa s; 0 where a law gives it or nothing asks for it
  double temperature = 0;        ///< of the matrix, K; only laws of viscosity ask for it
  double pressure = 0;           ///< likewise, Pa

  /// Rate of strain D = (kappa + kappaᵀ)/2, 1/s.
  [[nodiscard]] Mat3 rate_of_strain() const { return 0.5 * (gradient + gradient.transpose()); }
  /// Shear rate sqrt(2 D:D), 1/s.
  [[nodiscard]] double shear_rate() const { return std::sqrt(2 * rate_of_strain().squaredNorm()); }
  /// Angular velocity of the fluid Omega = curl u / 2, rad/s; W·p = Omega × p.
  [[nodiscard]] Vec3 angular_velocity() const {
    return 0.5 * Vec3(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0),
                      gradient(1, 0) - gradient(0, 1));
  }
};

/// Makes simple shear u_x = rate · y.
[[nodiscard]] Flow simple_shear(double rate, double viscosity = 0);

/// Frequent gradients of unit rate sqrt(2 D:D) = 1 1/s; multiply by the rate.
[[nodiscard]] Mat3 simple_shear_gradient();         ///< u_x = y
[[nodiscard]] Mat3 planar_elongation_gradient();    ///< diag(1, 0, -1)/2
[[nodiscard]] Mat3 uniaxial_elongation_gradient();  ///< diag(2, -1, -1)/(2 sqrt 3)
[[nodiscard]] Mat3 biaxial_elongation_gradient();   ///< the opposite

/// Largest principal rate of strain, 1/s: the distance of two fluid points changes at most at this relative
/// rate.
[[nodiscard]] double principal_rate(const Flow& flow);

}  // namespace fiberfate
