// A rod with the resistance of a prolate spheroid turns, moves and settles as the spheroid does.
#include <gtest/gtest.h>

#include "dynamics/drag_laws/ellipsoid.hpp"
#include "jeffery_orbit.hpp"
#include "physics/record.hpp"

namespace fiberfate {
namespace {

constexpr double rate = scenes::couette_rate;

// Jeffery's theory is exact for a spheroid: r_e is its own aspect ratio. The tolerance is the step's error.
TEST(EllipsoidDrag, TurnsWithTheSpheroidsOwnAspectRatio) {
  for (const double aspect_ratio : {2.0, 10.0, 50.0}) {
    const double length = 2 * scenes::glass.radius * aspect_ratio;
    DynamicsParameters parameters = scenes::lone_and_fixed_step(0.01 / rate);
    parameters.drag = "ellipsoid";
    Simulation simulation(
        parameters, FlowHistory::constant(rate, scenes::melt_viscosity),
        scenes::lone_fiber(scenes::nodes_of({.direction = Vec3(0, 1, 0.7), .length = length})));
    const auto orbit = jeffery::measure_half_turn(simulation, aspect_ratio);
    record("period of a spheroid of aspect ratio " + std::to_string(int(aspect_ratio)) + " (s)",
           jeffery::period(aspect_ratio, rate), orbit.period, 2e-4 * orbit.period);
    EXPECT_LT(orbit.orbit_constant_error, 1e-3);
  }
}

/// Drag of a nearly spherical spheroid, to first order in its eccentricity's square e²: a sphere of radius R
/// has 6 pi eta R and 8 pi eta R³.
TEST(EllipsoidDrag, TendsToStokesDragOfASphere) {
  const double radius = 1e-5;
  const RodDrag drag =
      EllipsoidDrag{1.0}({.length = 2 * radius * 1.001, .radius = radius, .fiber_length = 0});
  EXPECT_NEAR(drag.parallel, 6 * pi * radius, 1e-3 * drag.parallel);
  EXPECT_NEAR(drag.perpendicular, 6 * pi * radius, 1e-3 * drag.perpendicular);
  EXPECT_NEAR(drag.rotational, 8 * pi * std::pow(radius, 3), 3e-3 * drag.rotational);
  EXPECT_NEAR(drag.shape, 0.001, 1e-6);
}

/// Drag of a slender spheroid of semi-axes L/2 and a: with E = ln(L/a), 4 pi eta (L/2)/(E − 1/2) along and
/// 8 pi eta (L/2)/(E + 1/2) across (Kim & Karrila 1991, table 3.4, the limit e → 1); corrections are of order
/// (a/L)².
TEST(EllipsoidDrag, TendsToTheSlenderSpheroid) {
  const double half = 1e-3;
  const double radius = 1e-6;
  const double logarithm = std::log(2 * half / radius);
  const RodDrag drag = EllipsoidDrag{1.0}({.length = 2 * half, .radius = radius, .fiber_length = 0});
  EXPECT_NEAR(drag.parallel, 4 * pi * half / (logarithm - 0.5), 1e-5 * drag.parallel);
  EXPECT_NEAR(drag.perpendicular, 8 * pi * half / (logarithm + 0.5), 1e-5 * drag.perpendicular);
}

}  // namespace
}  // namespace fiberfate
