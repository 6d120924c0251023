// Evaluates the laws of drag on a rod.
#include "dynamics/drag.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace fiberfate {
namespace {

RodDrag bead_chain(double viscosity, double radius, double beads) {
  const double translation = 6 * pi * viscosity * radius * beads;
  const double lever = translation * radius * radius * (beads * beads - 1) / 3;
  const double spin = 8 * pi * viscosity * radius * radius * radius * beads;
  return {translation, translation, lever + spin, lever / (lever + spin)};
}

}  // namespace

RodDrag BeadDrag::operator()(const RodShape& rod) const {
  return bead_chain(viscosity, rod.radius, rod.length / (2 * rod.radius));
}

RodDrag IntegerBeadDrag::operator()(const RodShape& rod) const {
  // A rod of exactly m diameters must count m beads although its length is only known to round-off.
  const double beads = std::floor(rod.length / (2 * rod.radius) * (1 + 1e-9));
  return bead_chain(viscosity, rod.radius, std::max(1.0, beads));
}

RodDrag EllipsoidDrag::operator()(const RodShape& rod) const {
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
          e2 / (2 - e2)};
}

RodDrag rod_drag(DragLaw law, double viscosity, const RodShape& rod) {
  switch (law) {
    case DragLaw::ellipsoid:
      return EllipsoidDrag{viscosity}(rod);
    case DragLaw::beads_integer:
      return IntegerBeadDrag{viscosity}(rod);
    default:
      return BeadDrag{viscosity}(rod);
  }
}

}  // namespace fiberfate
