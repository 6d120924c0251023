// A fiber under steady loads takes the shape of an Euler-Bernoulli beam.
#include <gtest/gtest.h>

#include "base/constants.hpp"
#include "dynamics/chain_solver.hpp"
#include "physics/record.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

constexpr double half_length = 1.25e-3;  // m
const double stiffness = scenes::glass.bending_stiffness();

/// A force on a point of a rod.
struct Load {
  int rod;
  double lever;
  Vec3 force;
};

IndexedVector<NodeIndex, Vec3> solve(const FiberState& state, const std::vector<Load>& forces, double step) {
  RodLoads loads;
  std::vector<RodLoads::Claim> claims;
  std::vector<RodLoads::Slot> slots;
  for (const Load& load : forces) claims.push_back({RodIndex(load.rod), claims.size()});
  loads.arrange(state.node_count(), claims, slots);
  for (std::size_t i = 0; i < forces.size(); ++i)
    loads.slot(slots[i]) = {forces[i].lever, forces[i].force, {}};
  IndexedVector<NodeIndex, Vec3> velocity(state.position.size());
  IndexedVector<RodIndex, double> tension(state.position.size());
  Flow rest;
  rest.viscosity = scenes::melt_viscosity;
  ChainSolver solver;
  solver.arrange(state, {});
  solver.solve({state, state.position, loads, rest, step}, {velocity, tension});
  return velocity;
}

/// Lets a fiber at rest yield to balanced loads until it moves no more: implicit steps that are long against
/// its slowest relaxation time (0.1 s here) are a Newton iteration for the static shape.
void settle(FiberState& state, const std::vector<Load>& forces) {
  for (int i = 0; i < 20; ++i) {
    const double step = 1e4;
    const auto velocity = solve(state, forces, step);
    for (const NodeIndex node : state.nodes()) state.position[node] += step * velocity[node];
  }
}

/// A fiber of 2 n rods, held at its middle: by symmetry either half is a cantilever.
FiberState two_cantilevers(int n) {
  return scenes::lone_fiber(scenes::nodes_of({.length = 2 * half_length, .rods = 2 * n}));
}

double tip_deflection(const FiberState& state) {
  const NodeIndex middle(state.position.size() / 2);
  return 0.5 * (state.position.front() + state.position.back()).y() - state.position[middle].y();
}

/// Deflection F R³/(3 E I) of a cantilever of length R under a force F at its tip. A chain of n equal rods
/// with hinge moments E I theta / l integrates it by the trapezoidal rule, which adds exactly the part 1/(2
/// n²).
double theory_under_tip_force(double force) {
  return force * std::pow(half_length, 3) / (3 * stiffness);
}

TEST(Cantilever, UnderATipForceConvergesWithSecondOrder) {
  const double force = 3e-4 * stiffness / (half_length * half_length);  // a deflection of 1e-4 of the length
  for (const int n : {1, 2, 4, 8, 16, 32}) {
    FiberState state = two_cantilevers(n);
    const Vec3 up(0, force, 0);
    settle(state, {{0, 0.0, up}, {2 * n - 1, 1.0, up}, {n, 0.0, -2 * up}});
    const double expected = 1 + 0.5 / (n * n);
    // What is left is the geometric nonlinearity, of order (deflection / length)² = 1e-8, and round-off.
    record("deflection under a force at the tip over that of the beam, " + std::to_string(n) + " rods",
           expected, tip_deflection(state) / theory_under_tip_force(force), 1e-6 * expected);
  }
}

/// Deflection f R⁴/(8 E I) of a cantilever under a force f per length.
double theory_under_uniform_force(double density) {
  return density * std::pow(half_length, 4) / (8 * stiffness);
}

TEST(Cantilever, UnderAUniformForceConvergesWithSecondOrder) {
  const double density = 8e-4 * stiffness / std::pow(half_length, 3);
  std::vector<double> errors;
  for (const int n : {4, 8, 16, 32}) {
    FiberState state = two_cantilevers(n);
    std::vector<Load> loads = {{n, 0.0, Vec3(0, -2 * density * half_length, 0)}};
    for (int rod = 0; rod < 2 * n; ++rod) loads.push_back({rod, 0.5, Vec3(0, density * half_length / n, 0)});
    settle(state, loads);
    errors.push_back(tip_deflection(state) / theory_under_uniform_force(density) - 1);
  }
  for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_NEAR(errors[i - 1] / errors[i], 4, 0.05);
  record("deflection under a uniform force over that of the beam, 32 rods", 1, 1 + errors.back(), 2e-3);
}

/// A straight fiber under a uniform force f per length is balanced by uniform drag: it moves sideways with
/// f/(3 pi eta) without bending, however it is cut into rods.
TEST(StraightFiber, UnderAUniformForceStaysStraight) {
  const double density = 1e-2;  // N/m
  std::vector<Vec3> nodes;
  for (const double x : {0.0, 0.3e-3, 0.5e-3, 1.1e-3, 1.2e-3, 2.0e-3}) nodes.emplace_back(x, 0, 0);
  const FiberState state = scenes::lone_fiber(nodes);
  std::vector<Load> loads;
  for (const RodIndex rod : state.rods(FiberIndex(0)))
    loads.push_back({rod.value(), 0.5, density * state.rod_length[rod] * Vec3(0.5, 1, 0)});
  const Vec3 theory = density / (3 * pi * scenes::melt_viscosity) * Vec3(0.5, 1, 0);
  double largest = 0;
  for (const double step : {0.0, 1e-3}) {
    for (const Vec3& velocity : solve(state, loads, step))
      largest = std::max(largest, (velocity - theory).norm() / theory.norm());
  }
  record("largest relative error of a node's velocity", 0, largest, 1e-11);
}

}  // namespace
}  // namespace fiberfate
