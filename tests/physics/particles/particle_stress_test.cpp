// The stress that fibers add to the melt, and the power that they take, against closed forms and identities.
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "fibers/lattice_choice.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

constexpr double bead = 5e-6;      // m
constexpr double melt = 100;       // Pa s
constexpr double instant = 1e-19;  // s: a step in which nothing moves
const FiberMaterial thin{.radius = bead, .youngs_modulus = 73e9, .density = 2550};

const Mat3 shear = simple_shear_gradient();
const Mat3 planar = Vec3(1, -1, 0).asDiagonal();
const Mat3 uniaxial = Vec3(1, -0.5, -0.5).asDiagonal();

DynamicsParameters one_instant() {
  DynamicsParameters parameters;
  parameters.step.control = StepControl::fixed;
  parameters.step.initial = instant;
  parameters.contact.ramp = 1e-9;
  parameters.contact.friction = 0;
  return parameters;
}

ParticleStress stress_of(const FiberState& state, const Mat3& gradient,
                         const DynamicsParameters& parameters = one_instant()) {
  Simulation simulation(parameters, FlowHistory::constant({gradient, melt}), state);
  simulation.watch_stress(1);
  return *simulation.advance(1e9).stress;
}

/// A state without fibers whose cell follows the flow.
FiberState cell_in(const Mat3& gradient, double size) {
  FiberState state;
  state.materials = {thin};
  state.cell = cell_for(FlowHistory::constant({gradient, melt}), Vec3::Constant(size));
  return state;
}

FiberState rod_in(const Mat3& gradient, double beads, const Vec3& direction) {
  FiberState state = cell_in(gradient, 10 * beads * bead);
  append_fiber(state, {scenes::nodes_of({Vec3::Zero(), direction, 2 * bead * beads, 1}), 0});
  return state;
}

Mat3 symmetric(double s11, double s22, double s33, double s12, double s13, double s23) {
  Mat3 m;
  m << s11, s12, s13, s12, s22, s23, s13, s23, s33;
  return m;
}

void expect_same(const Mat3& found, const Mat3& expected, double relative) {
  EXPECT_LT((found - expected).norm(), relative * expected.norm()) << found << "\nfor\n" << expected;
}

void expect_sound(const ParticleStress& found, double relative = 1e-9) {
  Mat3 sum = Mat3::Zero();
  double scale = found.stress.norm();
  for (const Mat3& part : found.by_cause) {
    sum += part;
    scale += part.norm();
  }
  EXPECT_LT((sum - found.stress).norm(), relative * scale) << "the causes do not add up";
  double spent = 0;
  for (const double one : found.power) spent += std::abs(one);
  EXPECT_LT(std::abs(found.spent_power() - found.supplied_power), relative * spent) << "power is lost";
}

struct OneFiber {
  double beads;
  Vec3 direction;
  Mat3 gradient;
  Mat3 stresslet;  // N m
  double power;    // W
};

TEST(ParticleStress, OfOneRigidFiberIsTheClosedForm) {
  const OneFiber table[] = {
      {10, Vec3(1, 1, 0), shear, symmetric(1.9438604544e-11, 1.9438604544e-11, 0, 1.9438604544e-11, 0, 0),
       1.9438604544e-11},
      {10, Vec3(1, 1, 0), planar, symmetric(1.5097945277e-12, -1.5097945277e-12, 0, 0, 0, 0),
       3.0195890554e-12},
      {50, Vec3(3, 1, 1), uniaxial,
       symmetric(5.8429672806e-09, 6.4708001483e-10, 6.4708001483e-10, 1.9444479024e-09, 1.9444479024e-09,
                 6.4708001483e-10),
       5.1958872658e-09}};
  for (const OneFiber& one : table) {
    const FiberState state = rod_in(one.gradient, one.beads, one.direction);
    const ParticleStress found = stress_of(state, one.gradient);
    const double volume = state.cell.volume();
    expect_same(volume * found.stress, one.stresslet, 2e-10);
    EXPECT_NEAR(volume * found.into(PowerSink::drag), one.power, 2e-10 * one.power);
    expect_sound(found);
  }
}

/// Directions and weights that integrate polynomials over the sphere exactly up to the 11th degree.
struct SphereRule {
  std::vector<Vec3> direction;
  std::vector<double> weight;
  SphereRule() {
    // Gauss-Legendre with six points in the height, twelve around.
    const double height[] = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
    const double share[] = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
    for (int i = 0; i < 6; ++i) {
      const double z = i < 3 ? height[i] : -height[i - 3], r = std::sqrt(1 - z * z);
      for (int j = 0; j < 12; ++j) {
        const double angle = 2 * pi * (j + 0.5) / 12;
        direction.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        weight.push_back(share[i % 3] / 24);
      }
    }
  }
};

TEST(ParticleStress, OfIsotropicRigidFibersIsTheClosedForm) {
  const SphereRule rule;
  for (const auto& [beads, shear_viscosity] : {std::pair{10.0, 5.4855867840e-12}, {50.0, 6.5580495618e-10}}) {
    for (const Mat3& gradient : {shear, uniaxial}) {
      Mat3 mean = Mat3::Zero();
      for (std::size_t i = 0; i < rule.direction.size(); ++i) {
        const FiberState state = rod_in(gradient, beads, rule.direction[i]);
        mean += rule.weight[i] * state.cell.volume() * stress_of(state, gradient).stress;
      }
      const Mat3 expected = shear_viscosity * (gradient + gradient.transpose());
      expect_same(mean, expected, 2e-10);
    }
  }
}

FiberState crossed_rods(double height) {
  FiberState state;
  state.materials = {thin};
  state.cell = rectangular_cell(Vec3::Constant(0.15e-3));
  const double length = 20 * bead, distance = 1.9 * bead;
  append_fiber(state, {scenes::nodes_of({Vec3(7.5e-5, height, 7.5e-5), Vec3::UnitX(), length, 1}), 0});
  append_fiber(state,
               {scenes::nodes_of({Vec3(7.5e-5, height - distance, 7.5e-5), Vec3::UnitZ(), length, 1}), 0});
  wrap_fibers(state);
  return state;
}

TEST(ParticleStress, OfAContactIsForceTimesDistanceAlsoThroughTheBoundary) {
  for (const double height : {7.5e-5, 0.5 * bead}) {
    const FiberState state = crossed_rods(height);
    const ParticleStress found = stress_of(state, Mat3::Zero());
    EXPECT_NEAR(found.stress(1, 1), -1.71901129e4, 2e-5);
    EXPECT_NEAR(found.of(StressCause::contact)(1, 1), -1.71901129e4, 2e-5);
    EXPECT_LT(std::abs(found.stress(0, 0)) + std::abs(found.stress(2, 2)), 1e-6);
    EXPECT_NEAR(state.cell.volume() * found.into(PowerSink::drag), 7.914376e-04, 1e-9);
    EXPECT_NEAR(state.cell.volume() * found.into(PowerSink::contact), -7.914376e-04, 1e-9);
  }
}

FiberState bent_fiber() {
  FiberState state;
  state.materials = {thin};
  state.cell = rectangular_cell(Vec3::Constant(1e-3));
  const double length = 20 * bead, x = length * std::cos(0.25), y = -length * std::sin(0.25);
  append_fiber(state, {std::vector<Vec3>{{-x, y, 0}, {0, 0, 0}, {x, y, 0}}, 0});
  return state;
}

TEST(ParticleStress, OfABentFiberIsThatOfItsMoment) {
  const FiberState state = bent_fiber();
  const double volume = state.cell.volume();
  const ParticleStress resting = stress_of(state, Mat3::Zero());
  expect_same(volume * resting.stress, symmetric(-2.8240468386e-07, 7.0070335094e-08, 0, 0, 0, 0), 1e-9);
  EXPECT_NEAR(volume * resting.into(PowerSink::drag), 6.735669e-04, 1e-9);
  EXPECT_NEAR(volume * resting.into(PowerSink::bending), -6.735669e-04, 1e-9);
  const ParticleStress sheared = stress_of(state, 1000 * shear);
  expect_same(volume * sheared.stress,
              symmetric(-2.8240468386e-07, 7.0070335094e-08, 0, 1.0824014430e-08, 0, 0), 1e-9);
  expect_sound(sheared);
}

/// Bent fibers that lie as chance will have it, and overlap.
FiberState heap_in(const Mat3& gradient) {
  FiberState state = cell_in(gradient, 1.2e-4);
  std::uint32_t drawn = 0;
  const auto vector = [&drawn] {
    const auto one = uniform4(7, RandomStream::position, {drawn++, 0, 0});
    return Vec3(one[0] - 0.5, one[1] - 0.5, one[2] - 0.5);
  };
  for (int fiber = 0; fiber < 8; ++fiber) {
    std::vector<Vec3> nodes = {1.2e-4 * vector()};
    Vec3 direction = vector().normalized();
    for (int rod = 0; rod < 3; ++rod) {
      nodes.push_back(nodes.back() + 5e-5 * direction);
      direction = (direction + 0.2 * vector()).normalized();
    }
    append_fiber(state, {nodes, 0});
  }
  wrap_fibers(state);
  return state;
}

DynamicsParameters converged_step() {
  DynamicsParameters parameters = one_instant();
  parameters.step.initial = 1e-7;
  parameters.contact.force_constant = 5;
  parameters.contact.sweeps = 4000;
  return parameters;
}

TEST(ParticleStress, AddsUpAndLosesNoPowerOnceTheSweepsConverge) {
  for (const Mat3& gradient : {shear, planar, uniaxial}) {
    const FiberState state = heap_in(gradient);
    const ParticleStress found = stress_of(state, 100 * gradient, converged_step());
    EXPECT_GT(found.of(StressCause::contact).norm(), 0.01 * found.stress.norm()) << "nothing touches";
    EXPECT_LT(found.unanswered, 1e-16 * found.answered);
    expect_sound(found, 1e-6);
  }
}

// Places of contacts are those at the step's begin, and forces balance in its middle: that costs the first
// power of the step.
TEST(ParticleStress, LosesNoPowerToFriction) {
  DynamicsParameters parameters = converged_step();
  parameters.contact.friction = 0.3;
  parameters.step.initial = 1e-9;
  const FiberState state = heap_in(shear);
  const ParticleStress found = stress_of(state, 100 * shear, parameters);
  EXPECT_GT(found.of(StressCause::friction).norm(), 1e-3 * found.stress.norm());
  EXPECT_GT(found.into(PowerSink::friction), 0);
  expect_sound(found, 1e-6);
}

void expect_same_stress(const ParticleStress& found, const ParticleStress& expected, double relative) {
  expect_same(found.stress, expected.stress, relative);
  for (std::size_t i = 0; i < stress_causes; ++i)
    EXPECT_LT((found.by_cause[i] - expected.by_cause[i]).norm(), relative * expected.stress.norm());
  EXPECT_NEAR(found.spent_power(), expected.spent_power(), relative * std::abs(expected.spent_power()));
}

TEST(ParticleStress, DoesNotDependOnOriginImagesOrBasis) {
  for (const Mat3& gradient : {shear, uniaxial}) {
    const FiberState state = heap_in(gradient);
    const ParticleStress expected = stress_of(state, 100 * gradient);
    FiberState moved = state;
    for (const NodeIndex node : moved.nodes()) moved.position[node] += Vec3(3e-5, -7e-5, 2e-5);
    wrap_fibers(moved);
    expect_same_stress(stress_of(moved, 100 * gradient), expected, 1e-9);
    FiberState imaged = state;
    const Vec3 shift = imaged.cell.shift({1, -1, 2});
    for (const NodeIndex node : imaged.nodes(FiberIndex(3))) imaged.position[node] += shift;
    expect_same_stress(stress_of(imaged, 100 * gradient), expected, 1e-9);
  }
  FiberState slid = heap_in(shear);
  const ParticleStress expected = stress_of(slid, 100 * shear);
  slid.cell.lattice.col(1) += slid.cell.lattice.col(0);
  expect_same_stress(stress_of(slid, 100 * shear), expected, 1e-9);
}

TEST(ParticleStress, OfADoubledCellIsTheSame) {
  const FiberState state = heap_in(shear);
  FiberState doubled = state;
  const Vec3 shift = state.cell.lattice.col(2);
  for (const FiberIndex fiber : state.fibers()) {
    std::vector<Vec3> nodes;
    for (const Vec3& node : state.positions(fiber)) nodes.push_back(node + shift);
    append_fiber(doubled, {nodes, 0});
  }
  doubled.cell.lattice.col(2) *= 2;
  expect_same_stress(stress_of(doubled, 100 * shear), stress_of(state, 100 * shear), 1e-9);
}

TEST(ParticleStress, OfAMirrorImageChangesTheSignAcrossTheMirror) {
  const FiberState state = heap_in(shear);
  FiberState mirrored = state;
  for (const NodeIndex node : mirrored.nodes()) mirrored.position[node].z() *= -1;
  wrap_fibers(mirrored);
  const Mat3 mirror = Vec3(1, 1, -1).asDiagonal();
  expect_same(stress_of(mirrored, 100 * shear).stress, mirror * stress_of(state, 100 * shear).stress * mirror,
              1e-9);
}

}  // namespace
}  // namespace fiberfate
