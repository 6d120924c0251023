// The drag of a slender cylinder.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/law_text.hpp"
#include "dynamics/drag_laws/rod_drag.hpp"

namespace fiberfate {

/// Slender-body theory of a lone cylinder of aspect ratio r = L/2a: resistances per length
///   zeta_perp = 4 pi eta / (ln 2r + 0.193),   zeta_par = 2 pi eta / (ln 2r − 0.807)
/// Source: Batchelor, J. Fluid Mech. 44, 419 (1970).
///
/// L is the length of the whole fiber, whatever the number of its rods, and of the piece once it has broken:
/// resistances are per length, and the rods of a straight fiber add up to the fiber. A bent fiber counts its
/// length along the bend.
///
/// A line has no thickness that shear could turn, so each rod also resists spinning against the melt, with c
/// per length such that the whole straight fiber tumbles as Jeffery's spheroid of its aspect ratio r does:
///   rotational = zeta_perp l³/12 + c l,   c = zeta_perp L² / (6 (r² − 1)),   shape of the fiber (r² − 1)/(r²
///   + 1)
///
/// Valid for slender fibers, r > 10. Below r = 3.05, where the two resistances meet, both keep the value that
/// they have there, 2 pi eta, so that short pieces never resist more along than across. Neglects other fibers
/// (no screening) and the ends.
struct SlenderBodyDrag {
  static constexpr LawText text = {"slender_body", "a slender cylinder as long as the whole fiber",
                                   "Batchelor 1970, J. Fluid Mech. 44, 419"};
  /// ln 2r where both resistances are 2 pi eta.
  static constexpr double least_logarithm = 1.807;

  double viscosity;  ///< eta, Pa s

  [[nodiscard]] RodDrag operator()(const RodShape& rod) const {
    const double logarithm = std::max(std::log(2 * rod.fiber_aspect_ratio()), least_logarithm);
    const double perpendicular = 4 * pi * viscosity / (logarithm + 0.193);
    const double parallel = 2 * pi * viscosity / (logarithm - 0.807);
    const double ratio = std::max(rod.fiber_aspect_ratio(), 0.5 * std::exp(least_logarithm));
    const double squared = ratio * ratio;
    const double moment = rod.length * rod.length * rod.length / 12;
    const double lever = perpendicular * moment;
    // c l, with L = 2 a r.
    const double spin =
        perpendicular * rod.length * (2.0 / 3) * rod.radius * rod.radius * squared / (squared - 1);
    return {parallel * rod.length,
            perpendicular * rod.length,
            lever + spin,
            lever / (lever + spin),
            {parallel * moment, lever, 0}};
  }
};

}  // namespace fiberfate
