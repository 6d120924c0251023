// Tests the power that drag dissipates.
#include "dynamics/dissipation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"
#include "dynamics/drag_laws/drag_registry.hpp"

namespace fiberfate {
namespace {

constexpr double radius = 9.5e-6;
constexpr double viscosity = 200;

RodMotion some_motion() {
  RodMotion motion;
  motion.direction = Vec3(1, 2, -2) / 3;
  motion.slip = Vec3(3e-4, -1e-4, 2e-4);
  const Vec3 spin(1.5, -0.7, 0.4);
  motion.spin = spin - motion.direction.dot(spin) * motion.direction;
  motion.rate_of_strain << 3, 1, -2, 1, -1, 0.5, -2, 0.5, -2;
  return motion;
}

/// Stokes drag times velocity, summed over beads at s_k: each sees u(c) − v_c + s_k [D·p + (Omega − omega) ×
/// p], and turns against the melt with Omega − omega.
double sum_over_beads(int beads, const RodMotion& motion) {
  const Vec3 gradient = motion.rate_of_strain * motion.direction + motion.spin.cross(motion.direction);
  double power = 0;
  for (int k = 0; k < beads; ++k) {
    const double s = (2 * k - beads + 1) * radius;
    power += 6 * pi * viscosity * radius * (motion.slip + s * gradient).squaredNorm();
    power += 8 * pi * viscosity * std::pow(radius, 3) * motion.spin.squaredNorm();
  }
  return power;
}

double dissipation_of(const char* law, const RodShape& rod, const RodMotion& motion) {
  return rod_dissipation(drag_law_named(law).drag(viscosity, rod), motion);
}

TEST(Dissipation, OfBeadsIsTheSumOverTheBeads) {
  for (const int beads : {1, 2, 5, 131}) {
    const RodShape rod{.length = 2 * radius * beads, .radius = radius, .fiber_length = 0};
    const double expected = sum_over_beads(beads, some_motion());
    EXPECT_NEAR(dissipation_of("beads", rod, some_motion()), expected, 1e-12 * expected);
  }
}

/// A sphere that is held: 6 pi eta a u² + 8 pi eta a³ Omega² + (20/3) pi eta a³ D:D (Einstein 1906).
double theory_of_a_sphere(const RodMotion& motion) {
  const double volume = pi * viscosity * std::pow(radius, 3);
  return 6 * pi * viscosity * radius * motion.slip.squaredNorm() + 8 * volume * motion.spin.squaredNorm() +
         20.0 / 3 * volume * motion.rate_of_strain.squaredNorm();
}

// An ellipsoid one part in a hundred longer than wide differs from a sphere by about as much.
TEST(Dissipation, OfANearlySphericalEllipsoidIsThatOfASphere) {
  const RodShape rod{.length = 2.02 * radius, .radius = radius, .fiber_length = 0};
  const double expected = theory_of_a_sphere(some_motion());
  EXPECT_NEAR(dissipation_of("ellipsoid", rod, some_motion()), expected, 0.02 * expected);
}

/// Power a slender free fiber dissipates in steady stretching along itself: pi eta l³ (p·D·p)²/(6 (ln 2r −
/// 3/2)) for an ellipsoid of aspect ratio r (Batchelor 1970), to second order in 1/r.
TEST(Dissipation, OfASlenderEllipsoidAlongTheStretchIsBatchelors) {
  const double ratio = 1000;
  const RodShape rod{.length = 2 * radius * ratio, .radius = radius, .fiber_length = 0};
  RodMotion motion;
  motion.rate_of_strain = Vec3(2, -1, -1).asDiagonal();
  const double theory = pi * viscosity * std::pow(rod.length, 3) * 4 / (6 * (std::log(2 * ratio) - 1.5));
  EXPECT_NEAR(dissipation_of("ellipsoid", rod, motion), theory, 1e-4 * theory);
}

/// The same of a slender cylinder by its resistance per length: zeta_par L³/12 (p·D·p)².
TEST(Dissipation, OfASlenderBodyAlongTheStretchIsItsAxialDrag) {
  const double ratio = 131, length = 2 * radius * ratio;
  RodMotion motion;
  motion.rate_of_strain = Vec3(2, -1, -1).asDiagonal();
  const double along = 2 * pi * viscosity / (std::log(2 * ratio) - 0.807);
  const double theory = along * std::pow(length, 3) / 12 * 4;
  EXPECT_NEAR(dissipation_of("slender_body", {length, radius, length}, motion), theory, 1e-12 * theory);
}

// A rod that the melt turns freely by Jeffery's law dissipates least: any other spin costs more.
TEST(Dissipation, IsLeastForAFreeRodAndNeverNegative) {
  for (const DragRow& law : drag_laws()) {
    const RodDrag drag = law.drag(viscosity, {.length = 20 * radius, .radius = radius, .fiber_length = 0});
    RodMotion motion = some_motion();
    motion.slip.setZero();
    const Vec3 p = motion.direction;
    const Vec3 free = -drag.shape * p.cross(motion.rate_of_strain * p);
    motion.spin = free;
    const double least = rod_dissipation(drag, motion);
    EXPECT_GT(least, 0);
    for (const double factor : {0.5, 0.99, 1.01, 2.0}) {
      motion.spin = factor * free;
      EXPECT_GT(rod_dissipation(drag, motion), least);
    }
  }
}

double power_of_a_cut_fiber(const char* law, int rods) {
  const Flow flow = simple_shear(10, viscosity);
  const Vec3 p = Vec3(0.6, 0.64, 0.48).normalized();
  FiberState state;
  state.materials = {{.radius = radius, .youngs_modulus = 73e9, .density = 2550}};
  state.cell = rectangular_cell(Vec3::Constant(1e-3));
  std::vector<Vec3> nodes;
  for (int k = 0; k <= rods; ++k) nodes.push_back((double(k) / rods - 0.5) * 4e-4 * p);
  append_fiber(state, {.nodes = nodes, .material_id = 0});
  const Vec3 turning(0.3, -1.1, 0.2);
  for (const NodeIndex k : state.nodes()) {
    const Vec3& x = state.position[k];
    state.relative_velocity[k] = Vec3(1e-5, 2e-5, 0) + turning.cross(x) - flow.gradient * x;
  }
  return drag_dissipation(state, flow, law);
}

// A whole fiber that is cut into rods and moves as one dissipates the same.
TEST(Dissipation, DoesNotDependOnHowAFiberIsCut) {
  for (const char* law : {"beads", "slender_body"}) {
    const double one = power_of_a_cut_fiber(law, 1), four = power_of_a_cut_fiber(law, 4);
    EXPECT_NEAR(four, one, 1e-12 * one) << law;
  }
}

}  // namespace
}  // namespace fiberfate
