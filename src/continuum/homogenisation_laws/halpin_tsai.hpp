// Halpin and Tsai's stiffness of aligned fibers.
#pragma once

#include "base/law_text.hpp"
#include "continuum/homogenisation.hpp"

namespace fiberfate {

/// Each modulus by M (1 + zeta eta phi)/(1 - eta phi), eta = (F/M - 1)/(F/M + zeta), with F of the fiber, M
/// of the matrix; zeta is 2 r along the fibers.
struct HalpinTsai {
  static constexpr LawText text = {
      "halpin_tsai", "Semi-empirical interpolation; some strain may take energy from its material.",
      "Halpin, Kardos, Polym. Eng. Sci. 16, 344 (1976)"};

  static double interpolated(double fiber, double matrix, double zeta, double fraction) {
    const double eta = (fiber / matrix - 1) / (fiber / matrix + zeta);
    return matrix * (1 + zeta * eta * fraction) / (1 - eta * fraction);
  }

  static Mat6 stiffness(const CompositeMaterial& material, double r) {
    const double fraction = material.volume_fraction;
    const auto& [fiber_modulus, fiber_poisson] = material.fiber;
    const auto& [matrix_modulus, nu] = material.matrix;
    const double fiber_shear = fiber_modulus / (2 * (1 + fiber_poisson));
    const double matrix_shear = matrix_modulus / (2 * (1 + nu));
    EngineeringConstants c;
    c.e1 = interpolated(fiber_modulus, matrix_modulus, 2 * r, fraction);
    c.e2 = c.e3 = interpolated(fiber_modulus, matrix_modulus, 2, fraction);
    c.g12 = c.g31 = interpolated(fiber_shear, matrix_shear, 1, fraction);
    c.g23 = interpolated(fiber_shear, matrix_shear, (1 + nu) / (3 - nu - 4 * nu * nu), fraction);
    c.nu12 = fiber_poisson * fraction + nu * (1 - fraction);
    c.nu31 = c.nu12 * c.e3 / c.e1;
    c.nu23 = c.e2 / (2 * c.g23) - 1;
    return orthotropic_stiffness(c);
  }
};

}  // namespace fiberfate
