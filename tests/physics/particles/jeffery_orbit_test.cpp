// One rigid fiber tumbles in simple shear as Jeffery's theory says.
#include "jeffery_orbit.hpp"

#include <gtest/gtest.h>

#include "physics/record.hpp"

namespace fiberfate {
namespace {

constexpr double rate = scenes::couette_rate;

Simulation lone_rod(const Vec3& direction, double aspect_ratio, DynamicsParameters parameters) {
  const double length = 2 * scenes::glass.radius * aspect_ratio;
  FiberState state =
      scenes::lone_fiber(scenes::nodes_of({.direction = direction, .length = length, .rods = 1}));
  return Simulation(parameters, FlowHistory::constant(rate, scenes::melt_viscosity), std::move(state));
}

class JefferyPeriod : public testing::TestWithParam<double> {};

// 0.1 % is what the issue asks for; the step error at a strain of 0.02 a step is a hundred times smaller.
TEST_P(JefferyPeriod, OfOneRodOfBeads) {
  const double aspect_ratio = jeffery::aspect_ratio_of_beads(GetParam());
  Simulation simulation = lone_rod(Vec3::UnitY(), GetParam(), scenes::lone_and_fixed_step(0.02 / rate));
  const auto orbit = jeffery::measure_half_turn(simulation, aspect_ratio);
  const double theory = jeffery::period(aspect_ratio, rate);
  record("period of a rod of " + std::to_string(int(GetParam())) + " beads (s)", theory, orbit.period,
         1e-3 * theory);
}
INSTANTIATE_TEST_SUITE_P(Beads, JefferyPeriod, testing::Values(5, 10, 20, 50, 100, 400, 800));

TEST(JefferyOrbit, KeepsItsConstantOutOfThePlaneOfShear) {
  const double beads = 20;
  const double aspect_ratio = jeffery::aspect_ratio_of_beads(beads);
  for (const double height : {0.2, 1.0, 5.0}) {
    Simulation simulation = lone_rod(Vec3(0, 1, height), beads, scenes::lone_and_fixed_step(0.01 / rate));
    const auto orbit = jeffery::measure_half_turn(simulation, aspect_ratio);
    EXPECT_NEAR(orbit.period, jeffery::period(aspect_ratio, rate), 1e-4 * orbit.period);
    EXPECT_LT(orbit.orbit_constant_error, 1e-3) << "p_z/p_y = " << height;
  }
}

// The step that the error control chooses must do as well as a small fixed one.
TEST(JefferyOrbit, IsFollowedByTheAdaptiveStep) {
  const double beads = 50;
  const double aspect_ratio = jeffery::aspect_ratio_of_beads(beads);
  DynamicsParameters parameters;
  Simulation simulation = lone_rod(Vec3(0, 1, 0.5), beads, parameters);
  const auto orbit = jeffery::measure_half_turn(simulation, aspect_ratio);
  EXPECT_NEAR(orbit.period, jeffery::period(aspect_ratio, rate), 1e-3 * orbit.period);
  EXPECT_LT(orbit.orbit_constant_error, 1e-2);
}

// Viscosity carries no weight when nothing but the fluid acts: the orbit depends on strain alone.
TEST(JefferyOrbit, DoesNotDependOnViscosity) {
  const auto nodes = scenes::nodes_of({.direction = Vec3(0.3, 1, 0.2), .length = 1e-3, .rods = 1});
  std::vector<Vec3> end;
  for (const double viscosity : {1.0, 5000.0}) {
    Simulation simulation(scenes::lone_and_fixed_step(0.01 / rate), FlowHistory::constant(rate, viscosity),
                          scenes::lone_fiber(nodes));
    scenes::run_until(simulation, 5 / rate);
    end.push_back(scenes::end_to_end(simulation.state()));
  }
  EXPECT_LT((end[0] - end[1]).norm(), 1e-12 * end[0].norm());
}

}  // namespace
}  // namespace fiberfate
