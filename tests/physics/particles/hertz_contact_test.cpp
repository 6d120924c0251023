// Two crossed fibers that are pressed together sink into each other as Hertz says.
#include <gtest/gtest.h>

#include "dynamics/chain_solver.hpp"
#include "dynamics/contact_loads.hpp"
#include "fibers/contact_laws/contact_registry.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

/// Angle at which the fibers cross, and by how much they overlap in the beginning, m.
struct Crossing {
  double angle = pi / 2;
  double overlap = 0;
};

FiberState crossed_fibers(const Crossing& crossing) {
  const double length = 30 * scenes::glass.radius;
  FiberState state = scenes::empty_cell(6 * length);
  const Vec3 apart(0, 0, 2 * scenes::glass.radius - crossing.overlap);
  append_fiber(state,
               {.nodes = scenes::nodes_of({.direction = Vec3::UnitX(), .length = length}), .material_id = 0});
  append_fiber(
      state,
      {.nodes = scenes::nodes_of({.centre = apart,
                                  .direction = Vec3(std::cos(crossing.angle), std::sin(crossing.angle), 0),
                                  .length = length}),
       .material_id = 0});
  return state;
}

DynamicsParameters hertz(double step) {
  DynamicsParameters parameters = scenes::fixed_step(step);
  parameters.contact.law = "hertz";
  parameters.contact.friction = 0;
  return parameters;
}

double overlap_of(const FiberState& state) {
  return 2 * scenes::glass.radius - (state.position[NodeIndex(2)].z() - state.position[NodeIndex(0)].z());
}

/// Overlap after a time t of two rigid fibers that push each other apart in melt at rest: each resists with
/// zeta, so d(delta)/dt = −2 K delta^(3/2)/zeta and delta = (delta_0^(−1/2) + K t/zeta)^(−2); K delta^(3/2)
/// is Hertz' force.
double theory_of_parting(const Crossing& crossing, double time) {
  const double modulus = scenes::glass.youngs_modulus / (2 * (1 - 0.22 * 0.22));
  const double factor =
      4.0 / 3 * modulus * std::sqrt(scenes::glass.radius) * std::pow(std::sin(crossing.angle), -0.75);
  const double zeta = 3 * pi * scenes::melt_viscosity * 30 * scenes::glass.radius;
  return std::pow(1 / std::sqrt(crossing.overlap) + factor * time / zeta, -2);
}

// Steps of a fortieth of the time in which the overlap falls to a quarter: of first order in the step, which
// is about 2 % of the fall here, and halves with it.
TEST(HertzContact, PartsFibersAtTheRateOfItsForce) {
  for (const double angle : {pi / 2, 0.5}) {
    const Crossing crossing{angle, 2e-7};
    const double modulus = scenes::glass.youngs_modulus / (2 * (1 - 0.22 * 0.22));
    const double zeta = 3 * pi * scenes::melt_viscosity * 30 * scenes::glass.radius;
    const double time = zeta / (4.0 / 3 * modulus * std::sqrt(scenes::glass.radius * crossing.overlap));
    std::vector<double> error;
    for (const int steps : {200, 400}) {
      Simulation simulation(hertz(time / steps), FlowHistory::constant(0, scenes::melt_viscosity),
                            crossed_fibers(crossing));
      scenes::run_until(simulation, time);
      const double theory = theory_of_parting(crossing, time);
      error.push_back(std::abs(overlap_of(simulation.state()) / theory - 1));
    }
    EXPECT_LT(error[1], 0.02) << angle;
    EXPECT_LT(error[1], 0.6 * error[0]) << angle;
  }
}

// The statistics tell Hertz' force, the angle included.
TEST(HertzContact, IsWhatTheStatisticsTell) {
  for (const double angle : {pi / 2, 0.5}) {
    const Crossing crossing{angle, 2e-7};
    Simulation simulation(hertz(1e-9), FlowHistory::constant(0, scenes::melt_viscosity),
                          crossed_fibers(crossing));
    const ContactStatistics contacts = simulation.contact_statistics();
    EXPECT_EQ(contacts.contacts, 1);
    EXPECT_NEAR(contacts.max_overlap, crossing.overlap / scenes::glass.radius, 1e-9);
    const double modulus = scenes::glass.youngs_modulus / (2 * (1 - 0.22 * 0.22));
    const double theory = 4.0 / 3 * modulus * std::sqrt(scenes::glass.radius) *
                          std::pow(crossing.overlap, 1.5) * std::pow(std::sin(angle), -0.75);
    EXPECT_NEAR(contacts.largest_force, theory, 1e-8 * theory) << angle;
  }
}

// A crowded cell of glass under the default step: fibers sink in by hundredths of a radius (2 % under 10 mN),
// and none passes through another.
TEST(HertzContact, RunsInACrowd) {
  DynamicsParameters parameters;
  parameters.contact.law = "hertz";
  scenes::Scatter fibers = scenes::soft_fibers();
  fibers.material = scenes::glass;
  Simulation simulation(parameters, FlowHistory::constant(scenes::couette_rate, scenes::melt_viscosity),
                        scenes::scatter(fibers));
  scenes::run_until(simulation, 0.05);
  const ContactStatistics contacts = simulation.contact_statistics();
  EXPECT_GT(contacts.contacts, 5);
  EXPECT_LT(contacts.max_overlap, 0.1);
}

}  // namespace
}  // namespace fiberfate
