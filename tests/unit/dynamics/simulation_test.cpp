// Tests what a simulation refuses: times that are not ahead, parameters and fibers that cannot be stepped.
#include "dynamics/simulation.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

FiberState one_fiber() {
  FiberState state;
  state.materials = {{9.5e-6, 73e9, 2550}};
  state.cell = rectangular_cell(Vec3::Constant(1e-3));
  const std::vector<Vec3> nodes = {{2e-4, 2e-4, 5e-4}, {4e-4, 5e-4, 5e-4}, {6e-4, 8e-4, 5e-4}};
  append_fiber(state, {nodes, 0});
  return state;
}

Simulation simulation_of(const FiberState& state, const DynamicsParameters& parameters = {}) {
  return {parameters, FlowHistory::constant(10, 200), state};
}

// A step towards the past went backwards, one to the present was NaN.
TEST(Simulation, StepsOnlyAhead) {
  Simulation simulation = simulation_of(one_fiber());
  simulation.advance(1e-3);
  const double time = simulation.state().time;
  for (const double until : {time, 0.0, -1.0, -infinite, nan})
    EXPECT_THROW(simulation.advance(until), InputError) << until;
  EXPECT_EQ(simulation.state().time, time);
  EXPECT_GT(simulation.advance(std::nextafter(time, 1)).step_size, 0);
}

// Without an event ahead the step was infinity over infinity, and no trial ever ended.
TEST(Simulation, StepsWithoutAnEnd) {
  Simulation bounded = simulation_of(one_fiber()), endless = simulation_of(one_fiber());
  for (int i = 0; i < 20; ++i) {
    bounded.advance(1e9);
    EXPECT_GT(endless.advance(infinite).step_size, 0);
  }
  // Where an end is far away it rounds the step by its last bits.
  EXPECT_NEAR(endless.state().time, bounded.state().time, 1e-6 * bounded.state().time);
}

TEST(Simulation, RefusesFlowsThatNoCellFollows) {
  const auto refuses = [](const FlowHistory& flow) {
    EXPECT_THROW(Simulation(DynamicsParameters{}, flow, one_fiber()), InputError);
  };
  refuses(FlowHistory::constant(10, 0));
  refuses(FlowHistory::constant({planar_elongation_gradient(), 200}));
  const Flow across = {simple_shear_gradient().transpose(), 200};
  refuses(FlowHistory({{0, simple_shear(10, 200)}, {1, across}}));
  refuses(FlowHistory({{0, simple_shear(10, 200)}, {1, simple_shear(20, 200)}}, HistoryForm::ramps));
}

using Harm = std::function<void(FiberState&)>;

TEST(Simulation, RefusesFibersThatCannotBeStepped) {
  const Harm harms[] = {
      [](FiberState& s) { s.position[NodeIndex(1)].x() = infinite; },
      [](FiberState& s) { s.position[NodeIndex(2)].z() = nan; },
      [](FiberState& s) { s.relative_velocity[NodeIndex(0)].y() = nan; },
      [](FiberState& s) { s.rod_length[RodIndex(1)] = 0; },
      [](FiberState& s) { s.rod_length[RodIndex(0)] = infinite; },
      [](FiberState& s) { s.cell.lattice(1, 1) = nan; },
      [](FiberState& s) { s.cell.lattice.col(2).setZero(); },
      [](FiberState& s) { s.materials[0].radius = 0; },
      [](FiberState& s) { s.materials[0].youngs_modulus = infinite; },
      [](FiberState& s) { s.material_id[FiberIndex(0)] = 1; },
      [](FiberState& s) { s.cell = rectangular_cell(Vec3(1e-3, 1e-3, 1e-6)); },  // 721 times as long
  };
  for (const Harm& harm : harms) {
    FiberState state = one_fiber();
    harm(state);
    EXPECT_THROW((void)simulation_of(state), InputError) << &harm - harms;
  }
  EXPECT_NO_THROW((void)simulation_of(one_fiber()));
}

using Slip = std::function<void(DynamicsParameters&)>;

TEST(Simulation, RefusesParametersThatMakeNoSense) {
  const Slip slips[] = {
      [](DynamicsParameters& p) { p.drag = "oil"; },
      [](DynamicsParameters& p) { p.hinge = "rusty"; },
      [](DynamicsParameters& p) { p.contact.law = "soft"; },
      [](DynamicsParameters& p) { p.contact.friction_law = "none"; },
      [](DynamicsParameters& p) { p.breakage.law = "never"; },
      [](DynamicsParameters& p) { p.contact.force_constant = nan; },
      [](DynamicsParameters& p) { p.contact.ramp = 0; },
      [](DynamicsParameters& p) { p.contact.poisson_ratio = 1; },
      [](DynamicsParameters& p) { p.step.initial = 0; },
      [](DynamicsParameters& p) { p.step.maximum = infinite; },
      [](DynamicsParameters& p) { p.step.tolerance = -1; },
      [](DynamicsParameters& p) {
        p.breakage.law = "fixed";
        p.breakage.check_interval = 0;
      },
  };
  for (const Slip& slip : slips) {
    DynamicsParameters parameters;
    slip(parameters);
    EXPECT_THROW((void)simulation_of(one_fiber(), parameters), InputError) << &slip - slips;
  }
}

}  // namespace
}  // namespace fiberfate
