// Breakage conserves what it must and happens at the rate its law states, whatever the time step.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "dynamics/breakage_laws/breakage_registry.hpp"
#include "dynamics/breakage_laws/scattered_radius.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

using Name = std::pair<std::uint32_t, std::uint32_t>;

// --- Conservation
// ---------------------------------------------------------------------------------------------------

DynamicsParameters breaking_easily() {
  DynamicsParameters parameters;
  parameters.breakage.law = "fixed";
  parameters.breakage.critical_radius = 200e-6;
  parameters.breakage.check_interval = 2e-4;
  return parameters;
}

/// Rod lengths of every original fiber, along it, as its fragments hold them; and the places where it broke.
std::map<Name, double> rods_by_birth(const FiberState& state) {
  std::map<Name, double> rods;
  for (const FiberIndex f : state.fibers()) {
    for (const RodIndex k : state.rods(f)) {
      const auto along = state.birth_node[f] + std::uint32_t(first_end(k) - state.begin_node(f));
      const bool is_new = rods.insert({{state.birth_id[f], along}, state.rod_length[k]}).second;
      EXPECT_TRUE(is_new) << "a rod is there twice";
    }
  }
  return rods;
}

TEST(Breakage, ConservesEveryRodExactly) {
  const FiberState start = scenes::scatter(scenes::soft_fibers());
  Simulation simulation(breaking_easily(), FlowHistory::constant(300, 500), start);
  scenes::run_until(simulation, 1.5e-2);
  const FiberState& end = simulation.state();
  ASSERT_GT(end.breaks, 10);
  EXPECT_EQ(rods_by_birth(start), rods_by_birth(end));
  EXPECT_EQ(end.rod_count(), start.rod_count());
  EXPECT_EQ(end.fiber_count(), start.fiber_count() + end.breaks);
  for (const FiberIndex f : end.fibers()) {
    for (const RodIndex rod : end.rods(f))
      EXPECT_NEAR(end.axis(rod).norm(), end.rod_length[rod], 1e-13 * end.rod_length[rod]);
  }
}

TEST(Breakage, RecordsEveryBreak) {
  const FiberState start = scenes::scatter(scenes::soft_fibers());
  const DynamicsParameters parameters = breaking_easily();
  Simulation simulation(parameters, FlowHistory::constant(300, 500), start);
  scenes::run_until(simulation, 1.5e-2);
  const auto events = simulation.take_break_events();
  EXPECT_EQ(std::int64_t(events.size()), simulation.state().breaks);
  EXPECT_TRUE(simulation.take_break_events().empty());
  std::set<Name> places;
  for (const BreakEvent& event : events) {
    EXPECT_TRUE(places.insert({event.birth_id, event.birth_node}).second) << "one hinge broke twice";
    EXPECT_LT(event.radius, parameters.breakage.critical_radius);
    EXPECT_GT(event.child_length, 0);
    EXPECT_LT(event.child_length, event.parent_length);
    const double checks = event.time / parameters.breakage.check_interval;
    EXPECT_NEAR(checks, std::round(checks), 1e-6) << "a break between checks";
  }
  for (const FiberIndex f : simulation.state().fibers()) {
    const std::uint32_t along = simulation.state().birth_node[f];
    EXPECT_EQ(along > 0, places.count({simulation.state().birth_id[f], along}) == 1);
  }
}

// --- Laws
// -----------------------------------------------------------------------------------------------------------

constexpr int hinges = 4000;
constexpr double bend_radius = 140e-6;  // m

/// Fibers of two rods bent to one radius, of a material so soft that they stay bent, in a melt at rest and
/// without contact: each is one hinge under constant load.
FiberState bent_hinges() {
  FiberState state = scenes::empty_cell(1e-2, {.radius = 9.5e-6, .youngs_modulus = 1e-3, .density = 2550});
  const double length = 1e-4;
  const double half_turn = std::asin(length / (2 * bend_radius));
  for (int i = 0; i < hinges; ++i) {
    const std::vector<Vec3> nodes = {length * Vec3(-std::cos(half_turn), std::sin(half_turn), 0),
                                     Vec3::Zero(),
                                     length * Vec3(std::cos(half_turn), std::sin(half_turn), 0)};
    append_fiber(state, {.nodes = nodes, .material_id = 0});
  }
  return state;
}

struct Schedule {
  std::string law;
  double check_interval;
  double step;
};

std::vector<BreakEvent> break_hinges(const Schedule& schedule, double duration) {
  DynamicsParameters parameters = scenes::lone_and_fixed_step(schedule.step);
  parameters.breakage.law = schedule.law;
  parameters.breakage.check_interval = schedule.check_interval;
  Simulation simulation(parameters, FlowHistory::constant(0, scenes::melt_viscosity), bent_hinges());
  scenes::run_until(simulation, duration);
  return simulation.take_break_events();
}

/// P of (3.32) and (3.33) with m = 15, R_min = 119 µm, R_max = 371 µm, written as the thesis prints it.
double thesis_probability(double radius) {
  const double x = std::clamp((371e-6 - radius) / (371e-6 - 119e-6), 0.0, 1.0);
  return (std::exp(15 * x) - 1) / (std::exp(15.0) - 1);
}

TEST(Breakage, ProbabilityIsTheThesisFormula) {
  const BreakageParameters parameters;
  for (const double radius : {50e-6, 119e-6, 120e-6, 140e-6, 200e-6, 300e-6, 370e-6, 371e-6, 1e-3})
    EXPECT_NEAR(break_probability(parameters, radius), thesis_probability(radius), 1e-12);
  EXPECT_EQ(break_probability(parameters, 100e-6), 1);
  EXPECT_EQ(break_probability(parameters, 1e-3), 0);
}

// After n checks a hinge under constant load has survived with (1 − P)^n. Four standard deviations.
TEST(Breakage, OfTheProbabilityLawFollowsTheBinomialLaw) {
  const double p = thesis_probability(bend_radius);
  const auto events = break_hinges({"probability", 1e-3, 5e-4}, 4.5e-3);
  for (int n = 1; n <= 4; ++n) {
    const auto broken = std::count_if(events.begin(), events.end(),
                                      [n](const BreakEvent& event) { return event.time < (n + 0.5) * 1e-3; });
    const double expected = 1 - std::pow(1 - p, n);
    const double deviation = std::sqrt(hinges * expected * (1 - expected));
    EXPECT_NEAR(double(broken), hinges * expected, 4 * deviation) << "after " << n << " checks";
  }
}

std::set<Name> names(const std::vector<BreakEvent>& events) {
  std::set<Name> names;
  for (const BreakEvent& event : events) names.insert({event.birth_id, event.birth_node});
  return names;
}

// Draws are keyed by hinge and check, and checks come at fixed times: the step does not even change which
// hinges break.
TEST(Breakage, OfTheProbabilityLawDoesNotDependOnTheStep) {
  const auto coarse = break_hinges({"probability", 1e-3, 1e-3}, 4.5e-3);
  const auto fine = break_hinges({"probability", 1e-3, 1.7e-4}, 4.5e-3);
  EXPECT_GT(coarse.size(), 100u);
  EXPECT_EQ(names(coarse), names(fine));
}

// A probability a check is a rate: checks twice as often break about twice as many at first. That is the law
// as published, and why the strength law exists.
TEST(Breakage, OfTheProbabilityLawDependsOnTheCheckInterval) {
  const double p = thesis_probability(bend_radius);
  const auto often = break_hinges({"probability", 0.5e-3, 5e-4}, 4.2e-3);
  const double expected = 1 - std::pow(1 - p, 8);
  EXPECT_NEAR(double(often.size()), hinges * expected, 4 * std::sqrt(hinges * expected * (1 - expected)));
}

// With the strength law a hinge is either strong enough or not: the same hinges break at the first check,
// whenever that is, none later, and their share is P.
TEST(Breakage, OfTheStrengthLawDependsOnNeitherStepNorCheckInterval) {
  const auto often = break_hinges({"strength", 0.5e-3, 5e-4}, 4.2e-3);
  const auto seldom = break_hinges({"strength", 4e-3, 1e-3}, 4.2e-3);
  EXPECT_EQ(names(often), names(seldom));
  for (const BreakEvent& event : often) EXPECT_LT(event.time, 0.6e-3);
  const double p = thesis_probability(bend_radius);
  EXPECT_NEAR(double(often.size()), hinges * p, 4 * std::sqrt(hinges * p * (1 - p)));
}

TEST(Breakage, OfTheFixedLawHappensBelowTheCriticalRadiusOnly) {
  for (const double factor : {0.999, 1.001}) {
    DynamicsParameters parameters = scenes::lone_and_fixed_step(1e-3);
    parameters.breakage.law = "fixed";
    parameters.breakage.critical_radius = factor * bend_radius;
    Simulation simulation(parameters, FlowHistory::constant(0, scenes::melt_viscosity), bent_hinges());
    scenes::run_until(simulation, 1.5e-3);
    EXPECT_EQ(simulation.state().breaks, factor > 1 ? hinges : 0);
  }
}

// Strengths of fragments are those of the hinges they had before: a break changes no other hinge's fate.
TEST(Breakage, StrengthBelongsToTheMaterialPoint) {
  const BreakageRow& law = breakage_law_named("strength");
  int broken = 0;
  for (std::uint32_t node = 1; node <= 100; ++node) {
    CheckedHinge hinge{.radius = 150e-6, .name = {.birth_id = 7, .birth_node = node}};
    const bool now = law.breaks({}, hinge);
    broken += now ? 1 : 0;
    for (const std::int64_t check : {1, 10, 1000000}) {
      hinge.check = check;
      EXPECT_EQ(law.breaks({}, hinge), now) << node;
    }
  }
  EXPECT_GT(broken, 0);
  EXPECT_LT(broken, 100);
}

}  // namespace
}  // namespace fiberfate
