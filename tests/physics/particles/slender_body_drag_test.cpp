// A fiber with the drag of a slender body moves, tumbles and breaks as one body, however it is cut into rods.
#include <gtest/gtest.h>

#include "dynamics/chain_solver.hpp"
#include "fibers/state.hpp"
#include "jeffery_orbit.hpp"

namespace fiberfate {
namespace {

constexpr double rate = scenes::couette_rate;
/// A thousand times stiffer than glass: bent by the flow by less than 1e-4 of its length.
const FiberMaterial stiff{.radius = 9.5e-6, .youngs_modulus = 73e12, .density = 2550};

/// Resistance of a straight fiber per length, over viscosity, across and along itself (Batchelor 1970).
double theory_across(double aspect_ratio) {
  return 4 * pi / (std::log(2 * aspect_ratio) + 0.193);
}
double theory_along(double aspect_ratio) {
  return 2 * pi / (std::log(2 * aspect_ratio) - 0.807);
}

/// Velocities of the nodes of a fiber in melt at rest, pulled with the same force on every length, N/m.
IndexedVector<NodeIndex, Vec3> velocities_under(const FiberState& state, const Vec3& force_per_length) {
  std::vector<RodLoads::Claim> claims;
  for (const RodIndex rod : state.rods(FiberIndex(0))) claims.push_back({rod, 0});
  RodLoads loads;
  std::vector<RodLoads::Slot> slots;
  loads.arrange(state.node_count(), claims, slots);
  for (std::size_t i = 0; i < claims.size(); ++i)
    loads.slot(slots[i]) = {0.5, state.rod_length[claims[i].rod] * force_per_length, {}};
  IndexedVector<NodeIndex, Vec3> velocity(state.position.size());
  IndexedVector<RodIndex, double> tension(state.position.size());
  ChainSolver solver;
  solver.arrange(state, {.drag = "slender_body"});
  solver.solve({state, state.position, loads, simple_shear(0, scenes::melt_viscosity), 0},
               {velocity, tension});
  return velocity;
}

// Mobility: the same velocity at every node, whatever the cut. Round-off only, of a system whose tensions are
// large.
TEST(SlenderBodyDrag, MovesAsBatchelorSays) {
  const double aspect_ratio = 131;
  const Vec3 p = Vec3(1, 2, -1).normalized();
  const Vec3 across = p.unitOrthogonal();
  for (const int rods : {1, 6, 31}) {
    const FiberState state = scenes::lone_fiber(
        scenes::nodes_of({.direction = p, .length = 2 * stiff.radius * aspect_ratio, .rods = rods}));
    const double along_drag = scenes::melt_viscosity * theory_along(aspect_ratio);
    const double across_drag = scenes::melt_viscosity * theory_across(aspect_ratio);
    const Vec3 expected = 2e-3 / along_drag * p + 1e-3 / across_drag * across;
    for (const Vec3& velocity : velocities_under(state, 2e-3 * p + 1e-3 * across))
      EXPECT_LT((velocity - expected).norm(), 1e-10 * expected.norm()) << rods << " rods";
  }
}

jeffery::MeasuredOrbit orbit_of(int rods, double aspect_ratio) {
  DynamicsParameters parameters = scenes::lone_and_fixed_step(0.01 / rate);
  parameters.drag = "slender_body";
  const auto nodes = scenes::nodes_of(
      {.direction = Vec3(0, 1, 0.6), .length = 2 * stiff.radius * aspect_ratio, .rods = rods});
  Simulation simulation(parameters, FlowHistory::constant(rate, scenes::melt_viscosity),
                        scenes::lone_fiber(nodes, stiff));
  return jeffery::measure_half_turn(simulation, aspect_ratio);
}

// The whole fiber tumbles as Jeffery's spheroid of its aspect ratio. What is left is the step's error and the
// slight bending.
TEST(SlenderBodyDrag, TumblesAsOneFiberHoweverItIsCut) {
  for (const double aspect_ratio : {10.0, 50.0}) {
    const double theory = jeffery::period(aspect_ratio, rate);
    for (const int rods : {1, 5, 10}) {
      const auto orbit = orbit_of(rods, aspect_ratio);
      EXPECT_NEAR(orbit.period, theory, 1e-3 * theory) << rods << " rods";
      EXPECT_LT(orbit.orbit_constant_error, 1e-3) << rods << " rods";
    }
  }
}

// A piece has its own length, no longer that of the fiber that it came from: its rods resist more.
TEST(SlenderBodyDrag, OfAPieceIsThatOfItsOwnLength) {
  FiberState state = scenes::lone_fiber(scenes::nodes_of({.length = 2 * stiff.radius * 120, .rods = 12}));
  const double length = state.rod_length[RodIndex(0)];
  EXPECT_NEAR(unit_drag_of_rods(state, "slender_body")[RodIndex(0)].perpendicular,
              theory_across(120) * length, 1e-9 * length);
  const std::vector<NodeIndex> nodes = {NodeIndex(3)};
  split_fibers(state, nodes);
  const auto drag = unit_drag_of_rods(state, "slender_body");
  EXPECT_NEAR(drag[RodIndex(0)].perpendicular, theory_across(30) * length, 1e-9 * length);
  EXPECT_NEAR(drag[RodIndex(0)].parallel, theory_along(30) * length, 1e-9 * length);
  EXPECT_NEAR(drag[RodIndex(4)].perpendicular, theory_across(90) * length, 1e-9 * length);
}

}  // namespace
}  // namespace fiberfate
