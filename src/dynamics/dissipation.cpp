// Sums the power that drag dissipates.
#include "dynamics/dissipation.hpp"

#include "dynamics/drag_laws/drag_registry.hpp"

namespace fiberfate {

double rod_dissipation(const RodDrag& drag, const RodMotion& motion) {
  const StrainResistance& strain = drag.strain;
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

double drag_dissipation(const FiberState& state, const Flow& flow, std::string_view law) {
  const DragRow& row = drag_law_named(law);
  double sum = 0;
  RodMotion motion;
  motion.rate_of_strain = flow.rate_of_strain();
  for (const FiberIndex fiber : state.fibers()) {
    const double radius = state.material(fiber).radius;
    const double whole = fiber_length(state, fiber);
    for (const RodIndex rod : state.rods(fiber)) {
      const double length = state.rod_length[rod];
      const Vec3 p = state.axis(rod) / length;
      const Vec3& begin = state.relative_velocity[first_end(rod)];
      const Vec3& end = state.relative_velocity[second_end(rod)];
      const Vec3 turning = (end - begin) / length + flow.gradient * p;
      const Vec3 spin = flow.angular_velocity() - p.cross(turning);
      motion.direction = p;
      motion.slip = -0.5 * (begin + end);
      motion.spin = spin - p.dot(spin) * p;
      sum += rod_dissipation(row.drag(flow.viscosity, {length, radius, whole}), motion);
    }
  }
  return sum;
}

}  // namespace fiberfate
