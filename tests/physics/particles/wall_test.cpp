// Walls keep fibers in and hold them back by friction.
#include <gtest/gtest.h>

#include "fibers/contact_laws/contact_registry.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

constexpr double rate = 10;  // 1/s
const double radius = scenes::glass.radius;

FiberState between_walls(const scenes::StraightFiber& fiber, double size) {
  FiberState state = scenes::empty_cell(size);
  state.cell.boundary[1] = Boundary::walls;
  append_fiber(state, {.nodes = scenes::nodes_of(fiber), .material_id = 0});
  return state;
}

/// Least height of an axis above either wall over a run, m.
double least_height(FiberState state, double strain) {
  const double size = state.cell.height(1);
  DynamicsParameters parameters;
  Simulation simulation(parameters, FlowHistory::constant(rate, scenes::melt_viscosity), std::move(state));
  double least = size;
  while (simulation.state().time < strain / rate) {
    simulation.advance(strain / rate);
    for (const Vec3& x : simulation.state().position) least = std::min({least, x.y(), size - x.y()});
  }
  return least;
}

// A fiber that tumbles nearer to a wall than half its length is pushed off it; it sinks into the wall by no
// more than a fifth of its radius, which is what the penalty force lets happen.
TEST(Wall, KeepsATumblingFiberIn) {
  const double length = 4e-4;
  for (const double centre : {0.2, 0.8}) {
    const FiberState state = between_walls(
        {.centre = Vec3(0, centre * 1e-3, 0), .direction = Vec3(-1, 0.45, 0.1), .length = length, .rods = 4},
        1e-3);
    EXPECT_GT(least_height(state, 40), 0.8 * radius);
    EXPECT_LT(least_height(state, 40), 1.2 * radius) << "the fiber never met the wall";
  }
}

// Without walls the same fiber crosses the face of the cell.
TEST(Wall, IsWhatKeepsItIn) {
  FiberState state = between_walls(
      {.centre = Vec3(0, 2e-4 - 1e-5, 0), .direction = Vec3(-1, 0.45, 0.1), .length = 4e-4, .rods = 4}, 1e-3);
  state.cell.boundary[1] = Boundary::periodic;
  EXPECT_LT(least_height(state, 20), 0);
}

constexpr double beads = 50;
const double height = 0.95 * radius;  // of the axis: pressed into the wall by a twentieth of its radius
const double resistance = 6 * pi * scenes::melt_viscosity * radius * beads;

ContactParameters soft_contact(double friction) {
  ContactParameters contact;
  contact.force_constant = 1;
  contact.friction = 0;
  contact.wall_friction = friction;
  contact.slip_velocity = 1e-9;
  return contact;
}

/// Normal force on a rod that lies along a wall: the law of a rod and its mirror image, 2 h apart, at each of
/// its ends.
double normal_force() {
  return 2 * NormalForce(soft_contact(0), {{radius, 0}, {radius, 0}})(2 * height);
}

/// Velocity along x of a rod that lies across the flow on a wall, relative to the fluid at its axis. The
/// wall's own fluid rests relative to it, the fluid at the axis runs ahead of it by rate · height: sticking w
/// = −rate · height, sliding w = −mu F_N/(m zeta).
double theory(double friction) {
  return -std::min(rate * height, friction * normal_force() / resistance);
}

TEST(Wall, HoldsBackByCoulombFriction) {
  const double critical = resistance * rate * height / normal_force();
  for (const double share : {0.0, 0.5, 0.9, 1.1, 5.0}) {
    for (const bool upper : {false, true}) {
      const double size = 4e-3;
      DynamicsParameters parameters = scenes::fixed_step(1e-9);
      parameters.contact = soft_contact(share * critical);
      parameters.contact.sweeps = 20;
      const double y = upper ? size - height : height;
      Simulation simulation(
          parameters, FlowHistory::constant(rate, scenes::melt_viscosity),
          between_walls({.centre = Vec3(0, y, 0), .direction = Vec3::UnitZ(), .length = 2 * radius * beads},
                        size));
      scenes::run_until(simulation, 20e-9);
      const double sign = upper ? -1 : 1;
      for (const Vec3& w : simulation.state().relative_velocity) {
        EXPECT_NEAR(sign * w.x(), theory(share * critical), 1e-4 * rate * height)
            << "mu / critical mu = " << share;
        EXPECT_NEAR(sign * w.y(), normal_force() / resistance, 1e-3 * normal_force() / resistance);
      }
    }
  }
}

}  // namespace
}  // namespace fiberfate
