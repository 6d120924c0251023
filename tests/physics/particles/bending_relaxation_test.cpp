// A bent fiber in a melt at rest straightens at the rate of its first bending mode.
#include <gtest/gtest.h>

#include "jeffery_orbit.hpp"
#include "physics/record.hpp"

namespace fiberfate {
namespace {

constexpr double length = 2.5e-3;              // m
constexpr double wave = 4.730040745 / length;  // k: the first root of cos(kL) cosh(kL) = 1
const FiberMaterial& material = scenes::glass;

/// First bending mode of a beam with free ends, x from −L/2 to L/2, its largest value 1 at the ends.
double mode(double x) {
  return 0.5 * (std::cosh(wave * x) / std::cosh(wave * length / 2) +
                std::cos(wave * x) / std::cos(wave * length / 2));
}
double mode_slope(double x) {
  return 0.5 * wave *
         (std::sinh(wave * x) / std::cosh(wave * length / 2) -
          std::sin(wave * x) / std::cos(wave * length / 2));
}

/// Decay rate of the first mode, 1/s. The drag of a chain of beads resists sideways motion with 3 pi eta per
/// length and turning with 8 pi eta a³ − 2 pi eta a³ per bead, i.e. 3 pi eta a² per length, so that
///   rate = E I k⁴ / (3 pi eta (1 + a² <y'²>/<y²>)),
/// where the last term (a Rayleigh quotient, 4e-4 here) is the rotary drag that slender-body theory neglects.
double decay_rate() {
  double square = 0;
  double slope_square = 0;
  const int points = 2000;
  for (int i = 0; i < points; ++i) {
    const double x = ((i + 0.5) / points - 0.5) * length;
    square += mode(x) * mode(x);
    slope_square += mode_slope(x) * mode_slope(x);
  }
  const double rotary = material.radius * material.radius * slope_square / square;
  return material.bending_stiffness() * std::pow(wave, 4) / (3 * pi * scenes::melt_viscosity * (1 + rotary));
}

double amplitude(const FiberState& state) {
  const NodeIndex middle(state.position.size() / 2);
  return 0.5 * (state.position.front() + state.position.back()).y() - state.position[middle].y();
}

FiberState bent_fiber(int rods) {
  std::vector<Vec3> nodes = scenes::nodes_of({.length = length, .rods = rods});
  // Small enough for linear theory, (1e-4 L)², and far above round-off.
  for (Vec3& node : nodes) node.y() = 1e-4 * length * mode(node.x());
  return scenes::lone_fiber(nodes, material);
}

/// Decay rate over theory − 1, between 0.5 and 1 relaxation times: higher modes, which decay 7.6 times faster
/// or more, are gone by then.
double measured_error(int rods) {
  const double rate = decay_rate();
  Simulation simulation(scenes::lone_and_fixed_step(1e-4 / rate),
                        FlowHistory::constant(0, scenes::melt_viscosity), bent_fiber(rods));
  scenes::run_until(simulation, 0.5 / rate);
  const double first = amplitude(simulation.state());
  const double first_time = simulation.state().time;
  scenes::run_until(simulation, 1 / rate);
  const double second = amplitude(simulation.state());
  return std::log(first / second) / (simulation.state().time - first_time) / rate - 1;
}

// The hinges' stiffness, E I (2 sin(kl/2)/l)⁴, and the drag of straight rods, (2 + cos(kl))/3, are both too
// small by the factor 1 − k²l²/6: the leading errors cancel, and the rate converges with fourth order in the
// rod length l.
TEST(BendingRelaxation, ConvergesToTheFirstModeWithFourthOrder) {
  std::vector<double> errors;
  for (const int rods : {8, 16, 32}) errors.push_back(measured_error(rods));
  record("ratio of the differences of 8, 16 and 32 rods", 16,
         (errors[0] - errors[1]) / (errors[1] - errors[2]), 2.5);
  // Implicit steps of 1e-4 relaxation times lower the rate by half of that.
  record("rate of decay over that of the first mode, 32 rods", 1 - 0.5e-4, 1 + errors[2], 1e-5);
}

// A fiber that has straightened must have done so without drifting, turning or changing length.
TEST(BendingRelaxation, LeavesCentroidDirectionAndLength) {
  FiberState start = bent_fiber(25);
  const Vec3 centroid = fiber_centroid(start, FiberIndex(0));
  const double rate = decay_rate();
  Simulation simulation(scenes::lone_and_fixed_step(1e-2 / rate),
                        FlowHistory::constant(0, scenes::melt_viscosity), start);
  scenes::run_until(simulation, 5 / rate);
  EXPECT_LT((fiber_centroid(simulation.state(), FiberIndex(0)) - centroid).norm(), 1e-12 * length);
  EXPECT_LT(std::abs(scenes::end_to_end(simulation.state()).normalized().y()), 1e-9);
  double total = 0;
  for (const RodIndex rod : start.rods(FiberIndex(0))) total += simulation.state().axis(rod).norm();
  EXPECT_NEAR(total, fiber_length(start, FiberIndex(0)), 1e-13 * total);
}

}  // namespace
}  // namespace fiberfate
