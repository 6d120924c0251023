// A stiff fiber does not feel into how many rods it is cut.
#include <gtest/gtest.h>

#include "fibers/observables.hpp"
#include "jeffery_orbit.hpp"

namespace fiberfate {
namespace {

constexpr double rate = scenes::couette_rate;
constexpr double beads = 50;

/// A thousand times stiffer than glass: bent by the flow by less than 1e-4 of its length.
const FiberMaterial stiff{.radius = 9.5e-6, .youngs_modulus = 73e12, .density = 2550};

struct CutFiber {
  std::vector<Vec3> nodes;
  std::string drag = "beads";
};

jeffery::MeasuredOrbit orbit_of(const CutFiber& fiber) {
  DynamicsParameters parameters = scenes::lone_and_fixed_step(0.01 / rate);
  parameters.drag = fiber.drag;
  Simulation simulation(parameters, FlowHistory::constant(rate, scenes::melt_viscosity),
                        scenes::lone_fiber(fiber.nodes, stiff));
  return jeffery::measure_half_turn(simulation, jeffery::aspect_ratio_of_beads(beads));
}

std::vector<Vec3> equal_rods(int rods, double length_in_beads = beads) {
  const double length = 2 * stiff.radius * length_in_beads;
  return scenes::nodes_of({.direction = Vec3(0, 1, 0.6), .length = length, .rods = rods});
}

// Real-valued bead numbers add up over the rods of a straight fiber exactly; what is left is the step's error
// and the slight bending, both far below the 0.2 % that the issue asks for.
TEST(Segmentation, LeavesPeriodAndOrbitOfAStiffFiber) {
  const double theory = jeffery::period(jeffery::aspect_ratio_of_beads(beads), rate);
  for (const int rods : {1, 2, 5, 10, 25}) {
    const auto orbit = orbit_of({equal_rods(rods)});
    EXPECT_NEAR(orbit.period, theory, 1e-3 * theory) << rods << " rods";
    EXPECT_LT(orbit.orbit_constant_error, 1e-3) << rods << " rods";
  }
}

TEST(Segmentation, MayBeUnequal) {
  std::vector<Vec3> nodes = equal_rods(25);
  nodes.erase(nodes.begin() + 3, nodes.begin() + 9);
  nodes.erase(nodes.begin() + 10, nodes.begin() + 12);
  const double theory = jeffery::period(jeffery::aspect_ratio_of_beads(beads), rate);
  EXPECT_NEAR(orbit_of({nodes}).period, theory, 1e-3 * theory);
}

// The published program counts whole beads: 50.9 diameters are 50 beads in one rod, but in ten rods of 5.09
// diameters the 50 beads stand apart, and the fiber turns more slowly by about 1.6 %.
TEST(Segmentation, MattersWhenOnlyWholeBeadsCount) {
  const double one = orbit_of({equal_rods(1, 50.9), "beads_integer"}).period;
  const double many = orbit_of({equal_rods(10, 50.9), "beads_integer"}).period;
  EXPECT_NEAR(many / one, 1.016, 0.004);
}

}  // namespace
}  // namespace fiberfate
