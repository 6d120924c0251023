// Two crossing fibers that slide over each other obey Coulomb's law, from sticking to sliding.
#include <gtest/gtest.h>

#include "fibers/contact_laws/contact_registry.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

constexpr double rate = 10;   // 1/s
constexpr double beads = 50;  // a rod
const double radius = scenes::glass.radius;
const double distance = 1.9 * radius;  // of the axes: an overlap of a tenth of a radius
const double resistance = 6 * pi * scenes::melt_viscosity * radius * beads;  // m zeta

ContactParameters soft_contact(double friction) {
  ContactParameters contact;
  // Soft, so that friction can be weaker than the drag that slides the fibers.
  contact.force_constant = 1;
  contact.friction = friction;
  contact.slip_velocity = 1e-9;
  return contact;
}

/// Two rods that cross at their middles in the planes y = ± distance/2, into which neither turns. The flow
/// carries the upper one to +x and the lower one to −x.
FiberState crossing_rods() {
  const double length = 2 * radius * beads;
  FiberState state = scenes::empty_cell(4 * length);
  for (const double side : {1.0, -1.0}) {
    const auto nodes = scenes::nodes_of(
        {.centre = Vec3(0, side * distance / 2, 0), .direction = Vec3(1, 0, side), .length = length});
    append_fiber(state, {.nodes = nodes, .material_id = 0});
  }
  return state;
}

// Rotational drag of a rod over its drag, S2/m + zeta_r/zeta = a² (m² + 3)/3, and its shape factor.
const double turning = radius * radius * (beads * beads + 3) / 3;
const double shape = (beads * beads - 1) / (beads * beads + 3);
/// Slip of the skins of free rods: the shear separates the axes at rate · distance; the rods' rotation, spin
/// with the fluid about their axes (1, 0, ±1)/sqrt 2 and turning with the shape factor across them, takes
/// away the rest.
const double free_slip = (0.5 + 0.25 * shape) * rate * distance;
/// Velocity w of the upper rod along x relative to the fluid at which friction holds: friction F moves the
/// rods by F/(m zeta), and its couple turns them, so the slip is free_slip − 2 F/(m zeta) (1 + distance²/(8
/// turning)).
const double holding = free_slip / 2 / (1 + distance * distance / (8 * turning));

/// Velocity of the upper rod along x relative to the fluid: either friction holds, or it is overcome and
/// w = −mu F_N/(m zeta).
double theory(double friction) {
  const double normal = NormalForce(soft_contact(friction), {{radius, 0}, {radius, 0}})(distance);
  return -std::min(holding, friction * normal / resistance);
}

Vec3 middle_velocity(const FiberState& state, int fiber) {
  const NodeIndex first = state.begin_node(FiberIndex(fiber));
  return 0.5 * (state.relative_velocity[first] + state.relative_velocity[first + 1]);
}

// Steps of 1 ns move nothing; they only let the linearised friction converge.
FiberState settled(double friction) {
  DynamicsParameters parameters = scenes::fixed_step(1e-9);
  parameters.contact = soft_contact(friction);
  parameters.contact.sweeps = 20;
  Simulation simulation(parameters, FlowHistory::constant(rate, scenes::melt_viscosity), crossing_rods());
  scenes::run_until(simulation, 20e-9);
  return simulation.state();
}

TEST(Friction, SticksOrSlidesAsCoulombSays) {
  const double critical =
      resistance * holding / NormalForce(soft_contact(0), {{radius, 0}, {radius, 0}})(distance);
  for (const double share : {0.0, 0.1, 0.5, 0.9, 1.1, 2.0, 10.0}) {
    const FiberState state = settled(share * critical);
    const double expected = theory(share * critical);
    const double scale = rate * distance / 2;
    // 1e-4: the regularisation, slip velocity over sliding velocity, and 1e-9 s of motion.
    EXPECT_NEAR(middle_velocity(state, 0).x(), expected, 1e-4 * scale) << "mu / critical mu = " << share;
    EXPECT_NEAR(middle_velocity(state, 1).x(), -expected, 1e-4 * scale);
  }
}

TEST(Friction, LeavesTheNormalMotionAlone) {
  const double normal = NormalForce(soft_contact(0), {{radius, 0}, {radius, 0}})(distance);
  for (const double friction : {0.0, 0.3}) {
    const FiberState state = settled(friction);
    EXPECT_NEAR(middle_velocity(state, 0).y(), normal / resistance, 1e-4 * normal / resistance);
    EXPECT_NEAR(middle_velocity(state, 0).z(), 0, 1e-6 * normal / resistance);
  }
}

}  // namespace
}  // namespace fiberfate
