// The drag of a chain of touching beads.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/law_text.hpp"
#include "dynamics/drag_laws/rod_drag.hpp"

namespace fiberfate {

/// Resistance of m touching beads of radius a in a row:
///   parallel = perpendicular = 6 pi eta a m,   rotational = 6 pi eta a S2 + 8 pi eta a³ m,   S2 = a² m (m² −
///   1)/3
/// of which the strain of the melt drives the first part. A bead is a point to the strain. Neglects
/// hydrodynamic interaction of the beads. Source: thesis (3.4) to (3.9), corrected; Schmid, Switzer,
/// Klingenberg, J. Rheol. 44, 781 (2000).
[[nodiscard]] inline RodDrag drag_of_beads(double viscosity, double radius, double beads) {
  const double translation = 6 * pi * viscosity * radius * beads;
  const double lever = translation * radius * radius * (beads * beads - 1) / 3;
  const double spin = 8 * pi * viscosity * radius * radius * radius * beads;
  RodDrag drag{translation, translation, lever + spin, lever / (lever + spin), {}};
  // What turns a chain of beads by straining it is the second moment of their Stokes drag.
  const double moment = drag.rotational * drag.shape;
  drag.strain = {moment, moment, 0};
  return drag;
}

/// Beads of the real-valued number m = l/(2a), so that the rods of a straight fiber add up to the fiber
/// itself and r_e = sqrt((m² + 1)/2). Valid for l >= 2a.
struct BeadDrag {
  static constexpr LawText text = {"beads", "a chain of touching beads, whose number need not be whole",
                                   "thesis equations 3.4 to 3.9"};
  double viscosity;  ///< eta, Pa s
  [[nodiscard]] RodDrag operator()(const RodShape& rod) const {
    return drag_of_beads(viscosity, rod.radius, rod.length / (2 * rod.radius));
  }
};

/// The same with floor(l/(2a)) beads, at least one, as the published program counts them; for comparison
/// only: it makes the answer depend on how a fiber is cut into rods.
struct IntegerBeadDrag {
  static constexpr LawText text = {"beads_integer",
                                   "whole beads only, as in the published program; for comparison",
                                   "thesis equations 3.4 to 3.9"};
  double viscosity;  ///< eta, Pa s
  [[nodiscard]] RodDrag operator()(const RodShape& rod) const {
    // A rod of exactly m diameters must count m beads although its length is only known to round-off.
    const double beads = std::floor(rod.length / (2 * rod.radius) * (1 + 1e-9));
    return drag_of_beads(viscosity, rod.radius, std::max(1.0, beads));
  }
};

}  // namespace fiberfate
