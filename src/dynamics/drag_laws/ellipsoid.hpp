// The drag of a prolate spheroid.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/law_text.hpp"
#include "dynamics/drag_laws/rod_drag.hpp"

namespace fiberfate {

/// Prolate spheroid with semi-axes l/2 and a, resistance functions X^A, Y^A, Y^C, Y^H; exact for a lone
/// spheroid in Stokes flow: shape = Y^H/Y^C = (r² − 1)/(r² + 1), r = l/(2a) >= 1; nearly spherical
/// ones by their series in the eccentricity, where the closed forms lose all digits. Strain is resisted by
/// 10, 40/3, 20/3 times pi eta (l/2)³ times X^M, Y^M, Z^M. Source: Kim & Karrila (1991), table 3.4 and (5.8)
/// to (5.13).
struct EllipsoidDrag {
  static constexpr LawText text = {"ellipsoid", "a prolate spheroid", "Kim and Karrila 1991, table 3.4"};
  double viscosity;  ///< eta, Pa s

  [[nodiscard]] RodDrag operator()(const RodShape& rod) const {
    const double major = rod.length / 2;
    const double e = std::sqrt(std::max(1 - rod.radius * rod.radius / (major * major), 0.0));
    const Functions f = e < nearly_spherical ? series(e * e) : closed_forms(e);
    const double translation = 6 * pi * viscosity * major;
    const double scale = pi * viscosity * major * major * major;
    return {translation * f.x_a,
            translation * f.y_a,
            8 * scale * f.y_c,
            e * e / (2 - e * e),
            {10 * scale * f.x_m, 40.0 / 3 * scale * f.y_m, 20.0 / 3 * scale * f.z_m}};
  }

 private:
  /// Eccentricity below which the series to e^6 is better than the closed forms, to 1e-10 on either side.
  static constexpr double nearly_spherical = 0.08;

  struct Functions {
    double x_a, y_a, y_c, x_m, y_m, z_m;
  };

  static Functions closed_forms(double e) {
    const double e2 = e * e, e3 = e2 * e, e5 = e2 * e2 * e;
    const double logarithm = std::log((1 + e) / (1 - e));
    const double axial = -2 * e + (1 + e2) * logarithm;
    return {8.0 / 3 * e3 / axial,
            16.0 / 3 * e3 / (2 * e + (3 * e2 - 1) * logarithm),
            4.0 / 3 * e3 * (2 - e2) / axial,
            8.0 / 15 * e5 / ((3 - e2) * logarithm - 6 * e),
            4.0 / 5 * e5 * (2 * e * (1 - 2 * e2) - (1 - e2) * logarithm) /
                ((2 * e * (2 * e2 - 3) + 3 * (1 - e2) * logarithm) * axial),
            16.0 / 5 * e5 * (1 - e2) / (3 * (1 - e2) * (1 - e2) * logarithm - 2 * e * (3 - 5 * e2))};
  }

  /// The closed forms, expanded in x = e².
  static Functions series(double x) {
    return {1 + x * (-2.0 / 5 + x * (-17.0 / 175 - x * 128.0 / 2625)),
            1 + x * (-3.0 / 10 + x * (-57.0 / 700 - x * 907.0 / 21000)),
            1 + x * (-9.0 / 10 + x * (18.0 / 175 - x * 1.0 / 5250)),
            1 + x * (-6.0 / 7 + x * (1.0 / 49 - x * 128.0 / 11319)),
            1 + x * (-13.0 / 14 + x * (44.0 / 735 - x * 339.0 / 188650)),
            1 + x * (-8.0 / 7 + x * (17.0 / 147 + x * 184.0 / 11319))};
  }
};

}  // namespace fiberfate
