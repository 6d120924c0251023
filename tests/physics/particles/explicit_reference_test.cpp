// Compares the fast simulation with the slow one: all pairs, dense solves, explicit steps.
#include <gtest/gtest.h>

#include "reference/explicit_simulation.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

// Fibers longer than the cell, 10 % by volume: they meet one another and their own images. Glass would be too
// stiff for explicit steps.
FiberState crowded_cell() {
  return scenes::scatter({.fibers = 6,
                          .length = 2e-4,
                          .rods = 4,
                          .cell = 1.5e-4,
                          .seed = 3,
                          .material = {.radius = 9.5e-6, .youngs_modulus = 1e9, .density = 2550}});
}

/// Soft enough for explicit steps: a rod's node of drag 0.04 N s/m against 1000 N/m relaxes in 4e-5 s.
ContactParameters soft_contact(double friction) {
  ContactParameters contact;
  contact.force_constant = 100;
  contact.ramp = 2e-6;
  contact.friction = friction;
  // Explicit friction is stable only while mu F_N/v_0 is below the drag.
  contact.slip_velocity = 2e-2;
  return contact;
}

double largest_distance(const FiberState& a, const FiberState& b) {
  double largest = 0;
  for (const FiberIndex f : a.fibers()) {
    // Either may have moved a fiber to another image.
    const Vec3 apart = fiber_centroid(a, f) - fiber_centroid(b, f);
    const Vec3 images = (a.cell.lattice.inverse() * apart).array().round();
    for (const NodeIndex n : a.nodes(f))
      largest = std::max(largest, (a.position[n] - b.position[n] - a.cell.lattice * images).norm());
  }
  return largest;
}

struct Comparison {
  double distance = 0;       ///< largest distance of a node in the two, in radii
  double pushed = 0;         ///< largest distance from where nodes go without contact, in radii
  std::size_t contacts = 0;  ///< that the reference saw, summed over its steps
};

Comparison compare(const ContactParameters& contact, double step, int steps) {
  const FiberState start = crowded_cell();
  DynamicsParameters parameters = scenes::fixed_step(step);
  parameters.contact = contact;
  Simulation fast(parameters, FlowHistory::constant(100, scenes::melt_viscosity), start);
  reference::ExplicitSimulation slow(start, simple_shear(100, scenes::melt_viscosity), contact);
  Comparison comparison;
  for (int i = 0; i < steps; ++i) {
    slow.step(step);
    if (i % 50 == 0) comparison.contacts += slow.contacts().size();
  }
  scenes::run_until(fast, steps * step);
  parameters.contact.force_constant = 0;
  Simulation free(parameters, FlowHistory::constant(100, scenes::melt_viscosity), start);
  scenes::run_until(free, steps * step);
  comparison.pushed = largest_distance(fast.state(), free.state()) / scenes::glass.radius;
  comparison.distance = largest_distance(fast.state(), slow.state()) / scenes::glass.radius;
  return comparison;
}

// Both are of first order in the step while contacts close, with different constants: their distance must be
// small and fall with the step.
TEST(ExplicitReference, IsWhatTheFastSimulationTendsTo) {
  for (const double friction : {0.0, 0.3}) {
    const Comparison coarse = compare(soft_contact(friction), 1e-5, 800);
    const Comparison fine = compare(soft_contact(friction), 2.5e-6, 3200);
    EXPECT_GT(fine.contacts, 30u) << "without contacts nothing is compared";
    EXPECT_GT(fine.pushed, 0.1) << "contacts that do nothing are not compared";
    EXPECT_LT(fine.distance, 2e-3) << "friction " << friction;
    EXPECT_LT(fine.distance, 0.5 * coarse.distance) << "friction " << friction;
  }
}

}  // namespace
}  // namespace fiberfate
