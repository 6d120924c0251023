// A filling that is made from its state goes on as if it had never stopped, whatever happens.
#include <gtest/gtest.h>

#include <set>

#include "full_filling.hpp"
#include "same_state.hpp"

namespace fiberfate {
namespace {

using namespace test;

/// Leaves the state behind after every step, makes a filling of it, and lets both take the next step: where
/// all of these agree, so does a filling that is interrupted anywhere. Returns what happened on the way.
std::set<FillingEventKind> expect_resumable(const Shell& shell, const FillingParams& params) {
  const ShellMesh mesh(shell);
  Filling filling(mesh, params);
  while (!filling.finished() && !testing::Test::HasFailure()) {
    Filling resumed(mesh, params, filling.state());
    resumed.advance();
    filling.advance();
    SCOPED_TRACE("step " + std::to_string(filling.state().steps));
    expect_same(filling.state(), resumed.state());
    EXPECT_EQ(filling.viscosity(), resumed.viscosity());
  }
  std::set<FillingEventKind> kinds;
  for (const FillingEvent& event : filling.state().events) kinds.insert(event.kind);
  return kinds;
}

Trigger filled(double share) {
  return {TriggerKind::filled_fraction, share};
}

TEST(FillingResume, GatesSensorsAndSwitchover) {
  FillingParams params = full_params();
  params.sensors = {{"S1", {0.05, 0.02, 0}}};
  params.gates[0].intervals = {{{TriggerKind::start}, filled(0.4)}, {filled(0.6)}};
  params.gates[1].intervals = {{filled(0.3), {TriggerKind::arrival, 0.02, 0}}, {filled(0.7)}};
  Gate third = params.gates[0];
  third.position = {0.05, 0.02, 0};
  third.resistance = 1e10;
  third.intervals = {{{TriggerKind::arrival, 0.01, 0}}};
  params.gates.push_back(third);
  const auto kinds = expect_resumable(plaque(), params);
  for (const FillingEventKind kind : {FillingEventKind::gate_opened, FillingEventKind::gate_closed,
                                      FillingEventKind::switched_over, FillingEventKind::ended})
    EXPECT_TRUE(kinds.contains(kind)) << name(kind);
}

/// The front that a gate has made stands when it closes: nothing may go on there that the state does not
/// tell.
TEST(FillingResume, AFrontThatItsGateHasLeft) {
  FillingParams params = full_params();
  params.gates[0].position = {0, 0.02, 0};
  params.gates[1].position = {0.1, 0.02, 0};
  params.gates[1].intervals = {{{TriggerKind::start}, filled(0.4)}};
  EXPECT_TRUE(expect_resumable(plaque(), params).contains(FillingEventKind::gate_closed));
}

TEST(FillingResume, MeltThatStandsBehindClosedGates) {
  FillingParams params = full_params();
  params.gates[0].intervals = {{{TriggerKind::start}, {TriggerKind::time, 0.1}}, {{TriggerKind::time, 0.15}}};
  EXPECT_TRUE(expect_resumable(plaque(), params).contains(FillingEventKind::gate_closed));
}

TEST(FillingResume, PressureThatLimitsTheFlowForAWhile) {
  FillingParams params = full_params();
  params.process.flow = {{{0, 2e-5}, {0.5, 1e-6}}, ProfileAgainst::filled_fraction, ProfileForm::steps};
  params.process.pressure_limit = 6e6;
  const auto kinds = expect_resumable(plaque(), params);
  EXPECT_TRUE(kinds.contains(FillingEventKind::pressure_limited));
  EXPECT_TRUE(kinds.contains(FillingEventKind::flow_resumed));
}

TEST(FillingResume, MeltThatFreezesOff) {
  FillingParams params = full_params();
  params.process.flow = FlowProfile::constant(1e-7);
  params.process.pressure_limit = 60e6;
  const ShellMesh mesh(plaque());
  Filling filling(mesh, params);
  EXPECT_EQ(filling.run_to_end().stop_reason, FillingEnd::frozen);
  expect_resumable(plaque(), params);
}

/// Gates that have opened on dry places fill through their runners, slowly where these resist.
TEST(FillingResume, GatesThatFillThroughRunners) {
  FillingParams params = full_params();
  params.gates[0].resistance = 1e10;
  params.gates[1].resistance = 1e12;
  params.gates[1].intervals = {{}};
  params.gates[1].radius = 5e-3;  // several nodes
  EXPECT_TRUE(expect_resumable(plaque(), params).contains(FillingEventKind::gate_opened));
}

}  // namespace
}  // namespace fiberfate
