// Cells in any flow: motions of rigid fibers by theory, contacts through images that no remap changes, for
// ever.
#include <gtest/gtest.h>

#include "base/threads.hpp"
#include "fibers/lattice_choice.hpp"
#include "reference/bitwise_state.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

const Mat3 shear = simple_shear_gradient();
const Mat3 planar = Vec3(1, -1, 0).asDiagonal();
const Mat3 uniaxial = Vec3(1, -0.5, -0.5).asDiagonal();
const Mat3 biaxial = Vec3(1, 1, -2).asDiagonal();

Mat3 mixed(double alpha) {
  Mat3 gradient = shear;
  gradient(1, 0) = alpha;
  return gradient;
}

FlowHistory history(const Mat3& gradient) {
  return FlowHistory::constant({gradient, scenes::melt_viscosity});
}

FiberState rods_in(const FlowHistory& flow, double beads, const std::vector<Vec3>& directions) {
  const double length = 2 * scenes::glass.radius * beads;
  FiberState state = scenes::empty_cell(1);
  state.cell = cell_for(flow, Vec3::Constant(4 * length));
  for (const Vec3& p : directions) append_fiber(state, {scenes::nodes_of({Vec3::Zero(), p, length, 1}), 0});
  return state;
}

struct Motion {
  Mat3 gradient;
  double time;
  Vec3 direction;  // at the time
};

// The step error is of second order: a thousand steps leave some 1e-6 of the direction, ten times as many
// 1e-8.
TEST(OneRod, TurnsInAnyFlowByTheExponentialOfItsGradient) {
  const Motion table[] = {{planar, 1, Vec3(0.783639263922, 0.216360736078, 0.582320818728)},
                          {uniaxial, 1, Vec3(0.842051945465, 0.381410881556, 0.381410881556)},
                          {mixed(0.5), 2, Vec3(0.783723435567, 0.585333510281, 0.207755284616)},
                          {shear, 2, Vec3(0.870136124242, 0.345861642072, 0.351059610084)}};
  for (const Motion& motion : table) {
    double error[2];
    for (int i = 0; i < 2; ++i) {
      const FlowHistory flow = history(motion.gradient);
      Simulation simulation(scenes::lone_and_fixed_step(motion.time / (i == 0 ? 1e3 : 1e4)), flow,
                            rods_in(flow, 20, {Vec3(1, 2, 2) / 3}));
      scenes::run_until(simulation, motion.time);
      error[i] = (scenes::end_to_end(simulation.state()).normalized() - motion.direction).norm();
    }
    EXPECT_LT(error[1], 2e-8) << motion.gradient;
    EXPECT_NEAR(error[0] / error[1], 100, 25) << motion.gradient;
  }
}

/// Turns of a rod in a mixed flow: rate times the period in which p comes back.
double period_of(double beads, double alpha, double step) {
  const FlowHistory flow = history(mixed(alpha));
  Simulation simulation(scenes::lone_and_fixed_step(step), flow, rods_in(flow, beads, {Vec3::UnitY()}));
  double last = 0, turns = 0, time = 0;
  // Half turns of p: the angle passes the y axis again, going down.
  for (double angle = 0; turns < 1;) {
    const Vec3 before = scenes::end_to_end(simulation.state());
    last = time;
    simulation.advance(1e9);
    time = simulation.state().time;
    const Vec3 after = scenes::end_to_end(simulation.state());
    const double turned = std::atan2(before.cross(after).z(), before.dot(after)) / (-2 * pi);
    if (angle + turned >= 1) return last + (time - last) * (1 - angle) / turned;
    angle += turned;
  }
  return time;
}

TEST(OneRod, TumblesInMixedFlowsWithThePeriodOfTheory) {
  for (const auto& [beads, alpha, period] : {std::tuple{20.0, 0.0, 89.4123954758},
                                             {20.0, 0.001, 99.9976005848},
                                             {20.0, -0.5, 8.8748163374},
                                             {50.0, 0.0, 222.3662510804},
                                             {50.0, -0.5, 8.8839928023}})
    EXPECT_NEAR(period_of(beads, alpha, 2e-3), period, 2e-6 * period) << beads << ' ' << alpha;
}

/// Directions and weights of a rule that is exact for polynomials of high degree on the sphere.
struct SphereRule {
  std::vector<Vec3> direction;
  std::vector<double> weight;
  explicit SphereRule(int rings) {
    for (int i = 0; i < rings; ++i) {
      double z = std::cos(pi * (i + 0.75) / (rings + 0.5)), slope = 0;
      for (int newton = 0; newton < 8; ++newton) {
        double value = 1, before = 0;
        for (int n = 1; n <= rings; ++n) {
          const double next = ((2 * n - 1) * z * value - (n - 1) * before) / n;
          before = value;
          value = next;
        }
        slope = rings * (z * value - before) / (z * z - 1);
        z -= value / slope;
      }
      const double ring = 1 / ((1 - z * z) * slope * slope), r = std::sqrt(1 - z * z);
      for (int j = 0; j < 2 * rings; ++j) {
        direction.emplace_back(r * std::cos(pi * (j + 0.5) / rings), r * std::sin(pi * (j + 0.5) / rings), z);
        weight.push_back(ring / (2 * rings));
      }
    }
  }
};

TEST(IsotropicRods, OrientByTheoryInAnyFlow) {
  const SphereRule rule(40);
  for (const auto& [gradient, time, expected, a12] :
       {std::tuple{planar, 0.5, Vec3(0.531835386653, 0.161084957261, 0.307079656086), 0.0},
        {biaxial, 0.25, Vec3(0.417763450112, 0.417763450112, 0.164473099776), 0.0},
        {shear, 2.0, Vec3(0.575385622571, 0.163267545790, 0.261346831639), 0.204700514506}}) {
    const FlowHistory flow = history(gradient);
    Simulation simulation(scenes::lone_and_fixed_step(time / 2000), flow, rods_in(flow, 20, rule.direction));
    scenes::run_until(simulation, time);
    Mat3 a2 = Mat3::Zero();
    for (const FiberIndex fiber : simulation.state().fibers()) {
      const Vec3 p = scenes::end_to_end(simulation.state(), fiber).normalized();
      a2 += rule.weight[std::size_t(fiber.value())] * p * p.transpose();
    }
    EXPECT_LT((a2.diagonal() - expected).norm(), 1e-6) << gradient;
    EXPECT_NEAR(a2(0, 1), a12, 1e-6) << gradient;
  }
}

/// Fibers at 8 % by volume in a cell that follows a flow.
FiberState crowd_in(const FlowHistory& flow, double edge = 2.4e-4, std::uint32_t fibers = 40) {
  FiberState state = scenes::empty_cell(1, {.radius = 5e-6, .youngs_modulus = 73e9, .density = 2550});
  state.cell = cell_for(flow, Vec3::Constant(edge));
  for (std::uint32_t i = 0; i < fibers; ++i) {
    const auto u = uniform4(5, RandomStream::position, {i, 0, 0});
    const auto v = uniform4(5, RandomStream::orientation, {i, 0, 0});
    const Vec3 p = Vec3(v[0] - 0.5, v[1] - 0.5, v[2] - 0.5).normalized();
    append_fiber(state, {scenes::nodes_of({state.cell.lattice * Vec3(u[0], u[1], u[2]), p, 3.6e-4, 4}), 0});
  }
  wrap_fibers(state);
  return state;
}

TEST(CellInElongation, DoesNotNoticeANewBasis) {
  const FlowHistory flow = history(10 * uniaxial);
  FiberState state = crowd_in(flow), other = state;
  // The same lattice in a basis that is not compact.
  other.cell.frame.basis.col(0) += other.cell.frame.basis.col(1);
  other.cell.lattice = other.cell.frame.lattice();
  for (const FiberIndex fiber : {FiberIndex(2), FiberIndex(7)}) {
    const Vec3 shift = other.cell.shift({1, 2, -1});
    for (const NodeIndex node : other.nodes(fiber)) other.position[node] += shift;
  }
  Simulation one(scenes::fixed_step(1e-5), flow, state), two(scenes::fixed_step(1e-5), flow, other);
  for (int i = 0; i < 20; ++i) {
    one.advance(1);
    two.advance(1);
  }
  for (const NodeIndex node : one.state().nodes())
    EXPECT_LT((one.state().relative_velocity[node] - two.state().relative_velocity[node]).norm(), 1e-8);
}

TEST(CellInElongation, RunsToAHenckyStrainOfFiftyWithBreakage) {
  const FlowHistory flow = history(20 * uniaxial);
  DynamicsParameters parameters;
  parameters.breakage.law = "fixed";
  parameters.breakage.critical_radius = 3e-3;  // the slightest bend breaks
  Simulation simulation(parameters, flow, crowd_in(flow));
  const double volume = simulation.state().cell.volume();
  double nearest = 1;
  while (simulation.state().time < 2.5) {
    simulation.advance(2.5);
    nearest = std::min(nearest, nearest_image(simulation.state().cell));
  }
  EXPECT_GT(simulation.state().breaks, 0);
  EXPECT_GE(nearest, 0.905 * 2.4e-4);
  EXPECT_NEAR(simulation.state().cell.volume() / volume, 1, 1e-14);
  const FiberState& state = simulation.state();
  double aligned = 0;
  for (const FiberIndex fiber : state.fibers())
    aligned += std::abs(scenes::end_to_end(state, fiber).normalized().x());
  EXPECT_GT(aligned / state.fiber_count(), 0.999);
}

TEST(CellInElongation, ContinuesBitwiseAcrossAChangeOfBasis) {
  const FlowHistory flow = history(20 * uniaxial);
  Simulation whole(DynamicsParameters{}, flow, crowd_in(flow));
  scenes::run_until(whole, 0.03);
  Simulation resumed(DynamicsParameters{}, flow, whole.state());
  scenes::run_until(whole, 0.15);
  scenes::run_until(resumed, 0.15);
  EXPECT_NE(whole.state().cell.frame.basis, crowd_in(flow).cell.frame.basis) << "no basis changed";
  expect_bitwise_equal(whole.state(), resumed.state());
}

TEST(CellInElongation, IsTheSameWhenDoubled) {
  const FlowHistory flow = history(10 * uniaxial);
  const FiberState state = crowd_in(flow);
  FiberState doubled = state;
  const Vec3 shift = state.cell.lattice.col(1);
  for (const FiberIndex fiber : state.fibers()) {
    std::vector<Vec3> nodes(state.positions(fiber).begin(), state.positions(fiber).end());
    for (Vec3& node : nodes) node += shift;
    append_fiber(doubled, {nodes, 0});
  }
  doubled.cell.frame.basis.col(1) *= 2;
  doubled.cell.lattice = doubled.cell.frame.lattice();
  Simulation one(scenes::fixed_step(1e-5), flow, state), two(scenes::fixed_step(1e-5), flow, doubled);
  for (int i = 0; i < 20; ++i) {
    one.advance(1);
    two.advance(1);
  }
  for (const NodeIndex node : one.state().nodes()) {
    const Vec3& expected = one.state().relative_velocity[node];
    EXPECT_LT((two.state().relative_velocity[node] - expected).norm(), 1e-8);
    EXPECT_LT((two.state().relative_velocity[node + one.state().node_count()] - expected).norm(), 1e-8);
  }
}

/// The state after 150 steps of a crowd large enough to be shared between threads, and the stresses on the
/// way.
std::pair<FiberState, std::vector<Mat3>> stretched_with(int threads) {
  const int before = thread_count();
  use_threads(threads);
  const FlowHistory flow = history(20 * uniaxial);
  DynamicsParameters parameters;
  parameters.breakage.law = "fixed";
  parameters.breakage.critical_radius = 3e-3;
  Simulation simulation(parameters, flow, crowd_in(flow, 1e-3, 800));
  simulation.watch_stress(10);
  std::vector<Mat3> stresses;
  for (int i = 0; i < 150; ++i) {
    const StepReport report = simulation.advance(1);
    if (report.stress) stresses.push_back(report.stress->stress);
  }
  use_threads(before);
  return {simulation.state(), stresses};
}

TEST(ThreadInvariance, HoldsInElongationWithBreakageAndForStresses) {
  const auto [one, stress_of_one] = stretched_with(1);
  const auto [two, stress_of_two] = stretched_with(2);
  EXPECT_GT(one.breaks, 0);
  expect_bitwise_equal(one, two);
  EXPECT_EQ(stress_of_one, stress_of_two);
  EXPECT_EQ(stress_of_one.size(), 15U);
}

TEST(CellInAnOscillation, ComesBackWithItsFluid) {
  std::vector<FlowRow> rows = {{0, {10 * planar, 200}}, {0.05, {-10 * planar, 200}}};
  const FlowHistory flow = FlowHistory::repeated(rows, 0.1);
  FiberState state = crowd_in(flow);
  const Cell begin = state.cell;
  Simulation simulation(scenes::lone_and_fixed_step(1e-3), flow, std::move(state));
  scenes::run_until(simulation, 1);
  const Mat3 whole = begin.lattice.inverse() * simulation.state().cell.lattice;
  EXPECT_LT((whole - whole.array().round().matrix()).cwiseAbs().maxCoeff(), 1e-11);
}

}  // namespace
}  // namespace fiberfate
