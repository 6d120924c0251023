// Sums the power that drag dissipates.
#include "dynamics/dissipation.hpp"

#include <cmath>

#include "base/constants.hpp"

namespace fiberfate {
namespace {

/// Resistance of a rod that does not stretch to the strain of the melt, N m s.
struct StrainResistance {
  double along = 0;   ///< s_0, to stretching along the rod
  double aslant = 0;  ///< s_1, to shear that would turn it
  double across = 0;  ///< s_2, to strain across it
};

/// Resistance functions X^M, Y^M, Z^M of a prolate spheroid of eccentricity e; 1 for a sphere.
StrainResistance spheroid_functions(double e) {
  const double e2 = e * e, e5 = e2 * e2 * e;
  const double logarithm = std::log((1 + e) / (1 - e));
  const double x = 8.0 / 15 * e5 / ((3 - e2) * logarithm - 6 * e);
  const double y = 4.0 / 5 * e5 * (2 * e * (1 - 2 * e2) - (1 - e2) * logarithm) /
                   ((2 * e * (2 * e2 - 3) + 3 * (1 - e2) * logarithm) * (-2 * e + (1 + e2) * logarithm));
  const double z = 16.0 / 5 * e5 * (1 - e2) / (3 * (1 - e2) * (1 - e2) * logarithm - 2 * e * (3 - 5 * e2));
  return {x, y, z};
}

StrainResistance strain_resistance(DragLaw law, double viscosity, const RodShape& rod) {
  if (law == DragLaw::ellipsoid) {
    const double major = rod.length / 2;
    const double e = std::sqrt(1 - rod.radius * rod.radius / (major * major));
    const StrainResistance unit = spheroid_functions(e);
    const double scale = pi * viscosity * major * major * major;
    return {10 * scale * unit.along, 40.0 / 3 * scale * unit.aslant, 20.0 / 3 * scale * unit.across};
  }
  const RodDrag drag = rod_drag(law, viscosity, rod);
  // What turns a chain of beads by straining it is the second moment of their Stokes drag.
  const double moment = drag.rotational * drag.shape;
  return {moment, moment, 0};
}

}  // namespace

double rod_dissipation(DragLaw law, double viscosity, const RodShape& rod, const RodMotion& motion) {
  const RodDrag drag = rod_drag(law, viscosity, rod);
  const StrainResistance strain = strain_resistance(law, viscosity, rod);
  const Vec3& p = motion.direction;
  const Vec3 strained = motion.rate_of_strain * p;
  const double stretch = p.dot(strained);
  const double axial_slip = p.dot(motion.slip);
  const double sliding = drag.parallel * axial_slip * axial_slip +
                         drag.perpendicular * (motion.slip.squaredNorm() - axial_slip * axial_slip);
  const double turning =
      drag.rotational * (motion.spin.squaredNorm() + 2 * drag.shape * motion.spin.dot(p.cross(strained)));
  const double squared = stretch * stretch;
  const double total = motion.rate_of_strain.squaredNorm();
  return sliding + turning + strain.along * squared + strain.aslant * (strained.squaredNorm() - squared) +
         strain.across * (total - 2 * strained.squaredNorm() + 0.5 * squared);
}

double drag_dissipation(const FiberState& state, const Flow& flow, DragLaw law) {
  double sum = 0;
  RodMotion motion;
  motion.rate_of_strain = flow.rate_of_strain();
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    const double radius = state.material(fiber).radius;
    for (Index k = state.begin_node(fiber); k + 1 < state.end_node(fiber); ++k) {
      const auto n = static_cast<std::size_t>(k);
      const double length = state.rod_length[n];
      const Vec3 p = (state.position[n + 1] - state.position[n]) / length;
      const Vec3 turning =
          (state.relative_velocity[n + 1] - state.relative_velocity[n]) / length + flow.gradient * p;
      const Vec3 spin = flow.angular_velocity() - p.cross(turning);
      motion.direction = p;
      motion.slip = -0.5 * (state.relative_velocity[n] + state.relative_velocity[n + 1]);
      motion.spin = spin - p.dot(spin) * p;
      sum += rod_dissipation(law, flow.viscosity, {length, radius}, motion);
    }
  }
  return sum;
}

}  // namespace fiberfate
