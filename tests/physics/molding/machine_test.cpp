// Opens and closes gates, switches over, limits pressure, freezes off.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "test_shells.hpp"

namespace fiberfate {
namespace {

using namespace test;

constexpr double rate = 1e-6, eta = 100;

FillingParams strip_params(const Gate& gate) {
  return isothermal(rate, viscosity("newtonian", {eta}), gate);
}

const FillingEvent* find(const FillingState& state, FillingEventKind kind, int gate = -1) {
  for (const FillingEvent& event : state.events)
    if (event.kind == kind && event.gate == gate) return &event;
  return nullptr;
}

Rectangle coarse_strip() {
  return {0.08, 0.01, 0.002, 40, 4};
}

/// Two film gates at the ends of a strip with runners: q_g = (p_s - p_g)/R_g, p_g = 12 eta q x_g/(W H³). With
/// equal runners each front has gone half the way.
TEST(Gates, RunnersShareTheFlow) {
  const Rectangle r = coarse_strip();
  Gate left = film_gate({0, 0, 0}, {0, r.width, 0});
  Gate right = film_gate({r.length, 0, 0}, {r.length, r.width, 0});
  left.resistance = 1e12;
  right.resistance = 3e12;
  FillingParams params = strip_params(left);
  params.gates.push_back(right);
  Filling filling{ShellMesh(rectangle(r)), params};
  for (int step = 0; step < 150; ++step) filling.advance();
  const FillingState& state = filling.state();
  const double resistance_by_length = 12 * eta / (r.width * std::pow(r.thickness, 3));
  double rates[2], pressure = state.sprue_pressure;
  for (std::size_t g = 0; g < 2; ++g) {
    const GateState& gate = state.gates[g];
    const double before = gate.volume / (r.width * r.thickness);
    rates[g] = pressure / (params.gates[g].resistance + resistance_by_length * before);
    EXPECT_NEAR(gate.rate / rates[g], 1, 0.01);  // the front moved by 0.4 % of the strip in the step
    EXPECT_NEAR(gate.rate * params.gates[g].resistance + gate.pressure, pressure, 1e-9 * pressure);
  }
  EXPECT_NEAR(state.gates[0].rate + state.gates[1].rate, rate, 1e-10 * rate);
  EXPECT_EQ(filling.run_to_end().stop_reason, FillingEnd::filled);
}

/// Runners share the flow from the first drop on: with the fronts at the gates the flows are as 1/R. In every
/// step p_sprue - p_gate = R q.
TEST(Gates, RunnersCountFromTheFirstStep) {
  const Rectangle r = coarse_strip();
  Gate left = film_gate({0, 0, 0}, {0, r.width, 0});
  Gate right = film_gate({r.length, 0, 0}, {r.length, r.width, 0});
  left.resistance = 1e12;
  right.resistance = 3.2e13;
  FillingParams params = strip_params(left);
  params.gates.push_back(right);
  Filling filling{ShellMesh(rectangle(r)), params};
  fill(filling, [&] {
    const FillingState& state = filling.state();
    if (state.flow_rate == 0) return;  // all melt is in
    for (std::size_t g = 0; g < 2; ++g)
      ASSERT_NEAR(state.gates[g].rate * params.gates[g].resistance + state.gates[g].pressure,
                  state.sprue_pressure, 1e-9 * state.sprue_pressure);
    if (state.steps == 1) {
      EXPECT_NEAR(state.gates[0].rate / state.gates[1].rate, 32, 1e-9);
      EXPECT_NEAR(state.sprue_pressure, rate / (1e-12 + 1 / 3.2e13), 1e-6 * state.sprue_pressure);
    }
  });
  EXPECT_EQ(filling.state().stop_reason, FillingEnd::filled);
}

TEST(Gates, ValveGatesOpenAndCloseWhereTold) {
  const Rectangle r = coarse_strip();
  Gate first = film_gate({0, 0, 0}, {0, r.width, 0}), second = film_gate({0.04, 0, 0}, {0.04, r.width, 0});
  Gate third = film_gate({0.06, 0, 0}, {0.06, r.width, 0});
  first.intervals[0].closes = {TriggerKind::filled_fraction, 0.7};
  second.intervals[0].opens = {TriggerKind::arrival, 0.01};
  third.intervals[0].opens = {TriggerKind::time, 0.9};
  FillingParams params = strip_params(first);
  params.gates = {first, second, third};
  Filling filling{ShellMesh(rectangle(r)), params};
  const FillingState& state = filling.run_to_end();
  EXPECT_EQ(state.stop_reason, FillingEnd::filled);
  EXPECT_NEAR(find(state, FillingEventKind::gate_closed, 0)->filled_fraction, 0.7, 1e-10);
  const double arrival = state.gates[1].arrival_time;
  // The front reaches the gate's control volumes after half the strip and half a cell.
  EXPECT_NEAR(arrival, (0.04 + 0.001) * r.width * r.thickness / rate, 0.01);
  EXPECT_NEAR(find(state, FillingEventKind::gate_opened, 1)->time, arrival + 0.01, 1e-9);
  EXPECT_NEAR(find(state, FillingEventKind::gate_opened, 2)->time, 0.9, 1e-9);
  EXPECT_NEAR(state.injected_volume, state.gates[0].volume + state.gates[1].volume + state.gates[2].volume,
              1e-12 * state.injected_volume);
}

/// The pressure falls where a second gate opens: the front is nearer to it.
TEST(Gates, PressureDropsWhereAValveGateOpens) {
  const Rectangle r = coarse_strip();
  Gate second = film_gate({0.04, 0, 0}, {0.04, r.width, 0});
  second.intervals[0].opens = {TriggerKind::filled_fraction, 0.6};
  FillingParams params = strip_params(film_gate({0, 0, 0}, {0, r.width, 0}));
  params.gates.push_back(second);
  Filling filling{ShellMesh(rectangle(r)), params};
  double before = 0;
  while (!filling.state().gates[1].is_open()) {
    before = filling.state().sprue_pressure;
    filling.advance();
  }
  // 12 eta Q x/(W H³) with x = 0.048 m from the first and 0.008 m from the second gate, which takes all flow
  // towards the front; the first one stands at the same pressure.
  EXPECT_NEAR(filling.state().sprue_pressure / before, 0.008 / 0.048, 0.02);
}

/// Gate A closes when the front is at a sensor and opens again by volume; B opens at the sensor and closes
/// and opens again by time.
TEST(Gates, ReopenAndWaitForSensors) {
  const Rectangle r = coarse_strip();
  Gate a = film_gate({0, 0, 0}, {0, r.width, 0}), b = film_gate({0.02, 0, 0}, {0.02, r.width, 0});
  a.intervals = {{{TriggerKind::start}, {TriggerKind::arrival, 0.05, 0}},
                 {{TriggerKind::filled_fraction, 0.6}}};
  b.intervals = {{{TriggerKind::arrival, 0, 0}, {TriggerKind::time, 1.1}}, {{TriggerKind::time, 1.3}}};
  FillingParams params = strip_params(a);
  params.gates.push_back(b);
  params.sensors = {{"S1", {0.03, 0.005, 0}}};
  Filling filling{ShellMesh(rectangle(r)), params};
  const FillingState& state = filling.run_to_end();
  EXPECT_EQ(state.stop_reason, FillingEnd::filled);
  const double arrival = state.sensor_arrivals[0];
  EXPECT_NEAR(arrival, (0.03 + 0.001) * r.width * r.thickness / rate, 0.01);
  std::vector<double> moves[2];
  for (const FillingEvent& event : state.events)
    if (event.gate >= 0) moves[event.gate].push_back(event.time);
  const double volume = r.length * r.width * r.thickness;
  const std::vector<double> wanted[2] = {{0, arrival + 0.05, 0.6 * volume / rate}, {arrival, 1.1, 1.3}};
  for (int gate = 0; gate < 2; ++gate) {
    ASSERT_EQ(moves[gate].size(), wanted[gate].size());
    for (std::size_t i = 0; i < wanted[gate].size(); ++i)
      EXPECT_NEAR(moves[gate][i], wanted[gate][i], 1e-9) << gate << ' ' << i;
  }
  EXPECT_NEAR(state.injected_volume, state.gates[0].volume + state.gates[1].volume,
              1e-12 * state.injected_volume);
}

/// While all gates are closed and one will open again, the melt stands and time goes on.
TEST(Gates, MeltStandsUntilAGateOpensAgain) {
  const Rectangle r = coarse_strip();
  Gate gate = film_gate({0, 0, 0}, {0, r.width, 0});
  gate.intervals = {{{TriggerKind::start}, {TriggerKind::time, 0.5}}, {{TriggerKind::time, 0.8}}};
  Filling filling{ShellMesh(rectangle(r)), strip_params(gate)};
  while (filling.state().time < 0.5 - 1e-9) filling.advance();
  const double before = filling.state().injected_volume;
  filling.advance();
  EXPECT_EQ(filling.state().sprue_pressure, 0);
  while (filling.state().time < 0.8 - 1e-9) filling.advance();
  EXPECT_EQ(filling.state().injected_volume, before);
  EXPECT_EQ(filling.run_to_end().stop_reason, FillingEnd::filled);
  EXPECT_NEAR(filling.state().time, 0.3 + r.length * r.width * r.thickness / rate, 0.01);
}

TEST(Machine, SwitchoverHoldsThePressureFromTheVolumeOn) {
  FillingParams params = strip_params(film_gate({0, 0, 0}, {0, 0.01, 0}));
  params.process.switchover_fraction = 0.8;
  Filling filling{ShellMesh(rectangle(coarse_strip())), params};
  while (filling.state().control == ControlMode::flow) filling.advance();
  const double held = filling.state().held_pressure;
  EXPECT_NEAR(find(filling.state(), FillingEventKind::switched_over)->filled_fraction, 0.8, 1e-10);
  while (!filling.finished() && filling.filled_fraction() < 0.999) {
    filling.advance();
    EXPECT_NEAR(filling.state().sprue_pressure, held, 1e-9 * held);
    EXPECT_LE(filling.state().flow_rate, rate);
  }
  EXPECT_EQ(filling.run_to_end().stop_reason, FillingEnd::filled);
}

/// At constant pressure a strip fills as x² = x_1² + p H² (t - t_1)/(6 eta), which follows from Q = p W
/// H³/(12 eta x).
TEST(Machine, PressureLimitSlowsTheFront) {
  const Rectangle r = coarse_strip();
  FillingParams params = strip_params(film_gate({0, 0, 0}, {0, r.width, 0}));
  const double limit = 12 * eta * rate * 0.04 / (r.width * std::pow(r.thickness, 3));  // reached half-way
  params.process.pressure_limit = limit;
  Filling filling{ShellMesh(rectangle(r)), params};
  const FillingState& state = filling.run_to_end();
  EXPECT_EQ(state.stop_reason, FillingEnd::filled);
  const FillingEvent* limited = find(state, FillingEventKind::pressure_limited);
  EXPECT_NEAR(limited->filled_fraction, 0.5, 0.01);
  const double slow = (0.08 * 0.08 - 0.04 * 0.04) * 6 * eta / (limit * r.thickness * r.thickness);
  EXPECT_NEAR(state.time, 0.04 * r.width * r.thickness / rate + slow, 0.01 * state.time);
}

TEST(Machine, ProfilesSetTheRateAgainstTimeAndVolume) {
  const Rectangle r = coarse_strip();
  FillingParams params = strip_params(film_gate({0, 0, 0}, {0, r.width, 0}));
  params.process.flow = {{{0, rate}, {0.5, 2 * rate}}, ProfileAgainst::filled_fraction, ProfileForm::steps};
  const double volume = r.length * r.width * r.thickness;
  Filling by_volume{ShellMesh(rectangle(r)), params};
  EXPECT_NEAR(by_volume.run_to_end().time, 0.5 * volume / rate + 0.25 * volume / rate, 1e-3 * volume / rate);
  // A ramp from Q to 3 Q in one second brings in 2 Q.
  params.process.flow = {{{0, rate}, {1, 3 * rate}}, ProfileAgainst::time, ProfileForm::ramps};
  params.process.longest_time = 0.5;
  Filling by_time{ShellMesh(rectangle(r)), params};
  EXPECT_EQ(by_time.run_to_end().stop_reason, FillingEnd::time);
  EXPECT_NEAR(by_time.state().time, 0.5, 1e-12);
  EXPECT_NEAR(by_time.state().injected_volume, 0.75 * rate, 0.005 * rate);
}

TEST(Machine, WithoutAnOpenGateTheShotIsShort) {
  Gate gate = film_gate({0, 0, 0}, {0, 0.01, 0});
  gate.intervals[0].closes = {TriggerKind::filled_fraction, 0.4};
  Filling filling{ShellMesh(rectangle(coarse_strip())), strip_params(gate)};
  EXPECT_EQ(filling.run_to_end().stop_reason, FillingEnd::short_shot);
  EXPECT_NEAR(filling.filled_fraction(), 0.4, 1e-10);
  EXPECT_EQ(filling.state().events.back().kind, FillingEventKind::ended);
}

/// The last pockets take more pressure than the machine holds when nodes around them pass on what they have
/// too much; all the melt is in by then, and the cavity is full.
TEST(Machine, MeltThatIsInFillsTheCavity) {
  const Rectangle r{0.06, 0.06, 0.003, 12, 12};
  Shell shell = rectangle(r);
  for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
    Vec3 centre = Vec3::Zero();
    for (const Index node : shell.triangles[t]) centre += shell.nodes[node] / 3;
    if ((centre - Vec3(0.03, 0.03, 0)).norm() < 0.012) shell.thickness[t] = 0.0004;
  }
  for (const double switchover : {0.5, 0.7, 0.9}) {
    FillingParams params = strip_params(film_gate({0, 0, 0}, {0, r.width, 0}));
    params.process.switchover_fraction = switchover;
    params.numerics.steps = 60;
    Filling filling{ShellMesh(shell), params};
    EXPECT_EQ(filling.run_to_end().stop_reason, FillingEnd::filled) << switchover;
    EXPECT_NEAR(filling.filled_fraction(), 1, 1e-10);
    EXPECT_NEAR(filling.state().injected_volume / filling.mesh().total_volume(), 1, 1e-10);
  }
}

FillingParams cold_params(double flow) {
  FillingParams params = isothermal(flow, viscosity("cross_wlf", {25000, 0.3, 4e12, 263.15, 0, 26.5, 51.6}),
                                    film_gate({0, 0, 0}, {0, 0.01, 0}));
  params.material = {params.material.viscosity, 1000, 2300, 0.2, 273.15 + 135};
  params.process.inlet_temperature = 273.15 + 220;
  params.process.mold_temperature = 273.15 + 40;
  params.process.pressure_limit = 60e6;
  params.numerics.heat = HeatModel::full;
  params.numerics.steps = 100;
  return params;
}

/// A 1 mm gap freezes through in about H²/(pi² a) ln(4/pi · (T_melt - T_mold)/(T_no-flow - T_mold)) = 1.0 s
/// at a = 8.7e-8 m²/s; flow that takes 60 s cannot fill it, flow of 0.2 s can.
TEST(Machine, SlowFlowFreezesOffAndFastFlowFills) {
  Rectangle r = coarse_strip();
  r.thickness = 0.001;
  const double volume = r.length * r.width * r.thickness;
  Filling slow{ShellMesh(rectangle(r)), cold_params(volume / 60)};
  EXPECT_EQ(slow.run_to_end().stop_reason, FillingEnd::frozen);
  EXPECT_LT(slow.filled_fraction(), 0.5);
  EXPECT_LT(slow.state().time, 10);
  Filling fast{ShellMesh(rectangle(r)), cold_params(volume / 0.2)};
  EXPECT_EQ(fast.run_to_end().stop_reason, FillingEnd::filled);
}

/// Without a limit of its own the machine gives 1 GPa at most: slow melt freezes off instead of being pressed
/// through by whatever it takes, and no temperature leaves what flow can heat it to: p/(rho c) is 435 K at 1
/// GPa.
TEST(Machine, WithoutALimitSlowFlowFreezesOffToo) {
  Rectangle r = coarse_strip();
  r.thickness = 0.001;
  FillingParams params = cold_params(r.length * r.width * r.thickness / 60);
  params.process.pressure_limit = std::numeric_limits<double>::infinity();
  Filling filling{ShellMesh(rectangle(r)), params};
  const FillingState& state = filling.run_to_end();
  EXPECT_EQ(state.stop_reason, FillingEnd::frozen);
  EXPECT_LT(filling.filled_fraction(), 0.9);
  EXPECT_LE(state.sprue_pressure, 1e9 * (1 + 1e-9));
  // The machine's pressure and that of excess add up.
  EXPECT_LE(*std::max_element(state.pressure.begin(), state.pressure.end()), 2e9);
  EXPECT_LT(*std::max_element(state.temperature.begin(), state.temperature.end()), 273.15 + 220 + 500);
}

/// A melt that flow heats beyond what any polymer bears is a failure, in words, and not a result.
TEST(Machine, MeltThatNoPolymerBearsIsRefused) {
  FillingParams params = cold_params(1e-4);
  params.material.viscosity = viscosity("newtonian", {1e5});
  params.material.heat_capacity = 200;
  params.process.pressure_limit = std::numeric_limits<double>::infinity();
  Filling filling{ShellMesh(rectangle(coarse_strip())), params};
  try {
    filling.run_to_end();
    FAIL() << "it fills";
  } catch (const SimulationFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("which no polymer bears: check the viscosity"),
              std::string::npos)
        << failure.what();
  }
}

/// Melt that stands loses heat to the mold and gets none.
TEST(Machine, StandingMeltCools) {
  Rectangle r = coarse_strip();
  FillingParams params = cold_params(r.length * r.width * r.thickness / 0.5);
  params.gates[0].intervals = {{{TriggerKind::start}, {TriggerKind::time, 0.2}}, {{TriggerKind::time, 0.4}}};
  Filling filling{ShellMesh(rectangle(r)), params};
  while (filling.state().time < 0.2 - 1e-9) filling.advance();
  const HeatAccount before = filling.state().heat;
  const double stored = filling.stored_heat();
  while (filling.state().time < 0.4 - 1e-9) filling.advance();
  const HeatAccount& after = filling.state().heat;
  EXPECT_EQ(after.brought_in, before.brought_in);
  EXPECT_EQ(after.dissipated, before.dissipated);
  EXPECT_GT(after.to_mold - before.to_mold, 0.05 * stored);
  EXPECT_NEAR(after.to_mold - before.to_mold, stored - filling.stored_heat(), 1e-10 * stored);
  EXPECT_EQ(filling.run_to_end().stop_reason, FillingEnd::filled);
}

}  // namespace
}  // namespace fiberfate
