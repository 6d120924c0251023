// The drag of a prolate spheroid.
#pragma once

#include <cmath>

#include "base/constants.hpp"
#include "base/law_text.hpp"
#include "dynamics/drag_laws/rod_drag.hpp"

namespace fiberfate {

/// Prolate spheroid with semi-axes l/2 and a, resistance functions X^A, Y^A, Y^C, Y^H; exact for a lone
/// spheroid in Stokes flow: shape = Y^H/Y^C = (r² − 1)/(r² + 1), r = l/(2a) > 1. Strain is resisted by 10,
/// 40/3, 20/3 times pi eta (l/2)³ times X^M, Y^M, Z^M. Source: Kim & Karrila (1991), table 3.4 and (5.8) to
/// (5.13).
struct EllipsoidDrag {
  static constexpr LawText text = {"ellipsoid", "a prolate spheroid", "Kim and Karrila 1991, table 3.4"};
  double viscosity;  ///< eta, Pa s

  [[nodiscard]] RodDrag operator()(const RodShape& rod) const {
    const double major = rod.length / 2;
    const double e = std::sqrt(1 - rod.radius * rod.radius / (major * major));
    const double e2 = e * e;
    const double e3 = e2 * e;
    const double logarithm = std::log((1 + e) / (1 - e));
    const double axial = -2 * e + (1 + e2) * logarithm;
    const double x_a = 8.0 / 3 * e3 / axial;
    const double y_a = 16.0 / 3 * e3 / (2 * e + (3 * e2 - 1) * logarithm);
    const double y_c = 4.0 / 3 * e3 * (2 - e2) / axial;
    const double translation = 6 * pi * viscosity * major;
    return {translation * x_a, translation * y_a, 8 * pi * viscosity * major * major * major * y_c,
            e2 / (2 - e2), strain_resistance(major, e)};
  }

 private:
  [[nodiscard]] StrainResistance strain_resistance(double major, double e) const {
    const double e2 = e * e, e5 = e2 * e2 * e;
    const double logarithm = std::log((1 + e) / (1 - e));
    const double x = 8.0 / 15 * e5 / ((3 - e2) * logarithm - 6 * e);
    const double y = 4.0 / 5 * e5 * (2 * e * (1 - 2 * e2) - (1 - e2) * logarithm) /
                     ((2 * e * (2 * e2 - 3) + 3 * (1 - e2) * logarithm) * (-2 * e + (1 + e2) * logarithm));
    const double z = 16.0 / 5 * e5 * (1 - e2) / (3 * (1 - e2) * (1 - e2) * logarithm - 2 * e * (3 - 5 * e2));
    const double scale = pi * viscosity * major * major * major;
    return {10 * scale * x, 40.0 / 3 * scale * y, 20.0 / 3 * scale * z};
  }
};

}  // namespace fiberfate
