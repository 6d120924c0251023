// Balances volume, passive tracers and heat in a filling with all mechanisms.
#include <gtest/gtest.h>

#include <utility>

#include "continuum/length_registry.hpp"
#include "test_shells.hpp"

namespace fiberfate {
namespace {

using namespace test;

/// A plate that is thicker on one side, with a hole's worth of cells missing, fed by two gates.
Shell uneven_plate() {
  Rectangle r{0.1, 0.06, 0.002, 25, 15};
  Shell whole = rectangle(r), shell;
  std::vector<Index> renumbered(whole.nodes.size(), -1);
  for (const auto& triangle : whole.triangles) {
    const Vec3 centre = (whole.nodes[triangle[0]] + whole.nodes[triangle[1]] + whole.nodes[triangle[2]]) / 3;
    if ((centre - Vec3(0.05, 0.03, 0)).cwiseAbs().maxCoeff() < 0.012) continue;
    std::array<Index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      Index& number = renumbered[triangle[k]];
      if (number < 0) {
        number = static_cast<Index>(shell.nodes.size());
        shell.nodes.push_back(whole.nodes[triangle[k]]);
      }
      corners[k] = number;
    }
    shell.triangles.push_back(corners);
    shell.thickness.push_back(centre[1] < 0.03 ? 0.002 : 0.003);
  }
  return shell;
}

FillingParams thermal_params() {
  FillingParams params =
      isothermal(1e-5, viscosity("cross_wlf", {25000, 0.3, 4e12, 263.15, 0, 26.5, 51.6}), {});
  params.material = {params.material.viscosity, 1000, 2300, 0.2, 273.15 + 135};
  params.process.inlet_temperature = 273.15 + 240;
  params.process.mold_temperature = 273.15 + 50;
  params.numerics.heat = HeatModel::full;
  params.numerics.layers = 12;
  params.numerics.steps = 100;
  Gate first, second;
  first.position = Vec3(0.02, 0.02, 0);
  second.position = Vec3(0.08, 0.04, 0);
  second.resistance = 1e10;
  second.intervals[0].opens = {TriggerKind::filled_fraction, 0.3};
  params.gates = {first, second};
  const double still[] = {0, 1};
  params.fibers.length_sets = {{"tracer", make_attrition_law("constant", still)}};
  params.fibers.class_lengths = {1e-3, 5e-3};
  params.fibers.gate_inlets = {InletFibers{},
                               InletFibers{Mat3::Identity() / 3, InletAxes::part, {3e-3, 5e-3}, {}}};
  return params;
}

TEST(Conservation, VolumeTracerAndHeatAreKept) {
  Filling filling(ShellMesh(uneven_plate()), thermal_params());
  const FillingState& state = filling.state();
  const std::size_t layers = filling.layers().count();
  const double whole = filling.mesh().total_volume();
  fill(filling, [&] {
    double volume = 0, tracer = 0;
    for (std::size_t i = 0; i < filling.mesh().node_count(); ++i) {
      const double content = filling.mesh().volume(i) * state.filled[i] + state.excess[i];
      volume += content;
      for (std::size_t k = 0; k < layers && content > 0; ++k) {
        const auto lengths = filling.lengths(0, i, k);
        tracer += content * filling.layers().widths()[k] * lengths[0];
        // What comes in everywhere alike stays alike: mixing makes no new values.
        ASSERT_NEAR(lengths[1], 5e-3, 1e-15);
        ASSERT_GE(lengths[0], 1e-3 * (1 - 1e-12));
        ASSERT_LE(lengths[0], 3e-3 * (1 + 1e-12));
      }
    }
    const double brought = 1e-3 * state.gates[0].volume + 3e-3 * state.gates[1].volume;
    ASSERT_NEAR(volume, state.injected_volume, 1e-10 * whole);
    ASSERT_NEAR(tracer, brought, 1e-10 * brought);
    const HeatAccount& heat = state.heat;
    ASSERT_NEAR(heat.brought_in + heat.dissipated - heat.to_mold, filling.stored_heat(),
                1e-10 * heat.brought_in);
  });
  EXPECT_EQ(state.stop_reason, FillingEnd::filled);
  EXPECT_GT(state.gates[1].volume, 0.1 * whole);
}

/// What the sprue delivers, int of Q dt, is in the cavity, and has come through the gates: also where valves
/// open on melt that is on its way, close, and open again.
TEST(Conservation, ValvesLoseNothing) {
  FillingParams params = thermal_params();
  const auto filled = [](double share) { return Trigger{TriggerKind::filled_fraction, share}; };
  params.gates[0].intervals = {{{TriggerKind::start}, filled(0.55)}, {filled(0.8)}};
  params.gates[1].intervals = {{{TriggerKind::arrival, 0}, filled(0.6)}, {filled(0.62)}};
  Gate third;
  third.position = Vec3(0.05, 0.01, 0);
  third.radius = 5e-3;
  third.intervals = {{filled(0.5)}};
  params.gates.push_back(third);
  params.fibers = {};
  Filling filling(ShellMesh(uneven_plate()), params);
  const FillingState& state = filling.state();
  const double whole = filling.mesh().total_volume();
  double delivered = 0, before = 0;
  fill(filling, [&] {
    delivered += state.flow_rate * (state.time - std::exchange(before, state.time));
    double held = 0, entered = 0;
    for (std::size_t i = 0; i < filling.mesh().node_count(); ++i)
      held += filling.mesh().volume(i) * state.filled[i] + state.excess[i];
    for (const GateState& gate : state.gates) entered += gate.volume;
    ASSERT_NEAR(held, delivered, 1e-10 * whole);
    ASSERT_NEAR(entered, delivered, 1e-10 * whole);
    ASSERT_NEAR(state.injected_volume, delivered, 1e-12 * whole);
  });
  EXPECT_EQ(state.stop_reason, FillingEnd::filled);
  EXPECT_NEAR(filling.filled_fraction(), 1, 1e-10);
  EXPECT_NEAR(delivered, whole, 1e-10 * whole);
  EXPECT_EQ(state.events.size(), 8u);
}

/// The work of the gates, int of p Q dt, is what the flow turns into heat.
TEST(Conservation, HeatOfFlowIsTheWorkOfTheGates) {
  FillingParams params = thermal_params();
  Filling filling(ShellMesh(uneven_plate()), params);
  double work = 0, volume_before[2] = {0, 0};
  fill(filling, [&] {
    for (std::size_t g = 0; g < 2; ++g) {
      const GateState& gate = filling.state().gates[g];
      work += gate.pressure * (gate.volume - std::exchange(volume_before[g], gate.volume));
    }
  });
  // What closing pockets cannot hold is pushed on by the solver, not by the gates: the rest of a coarse step.
  EXPECT_NEAR(filling.state().heat.dissipated / work, 1, 0.01);
}

}  // namespace
}  // namespace fiberfate
