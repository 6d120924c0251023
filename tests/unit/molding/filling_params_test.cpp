// Tests the checks of filling parameters, profiles and gates.
#include "molding/filling_params.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "continuum/length_registry.hpp"
#include "molding/gate_nodes.hpp"
#include "plate.hpp"

namespace fiberfate {
namespace {

using test::plate;

ShellMesh square() {
  return ShellMesh(
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {0.002, 0.002}, {}, {}});
}

FillingParams sound() {
  FillingParams params;
  const double values[] = {100};
  params.material.viscosity = make_viscosity_law("newtonian", values);
  params.process.flow = FlowProfile::constant(1e-6);
  params.gates = {{}};
  return params;
}

std::string complaint(const FillingParams& params) {
  try {
    check_params(params, plate(1, 8));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FillingParamsChecks, SoundParametersPass) {
  EXPECT_EQ(complaint(sound()), "");
}

TEST(FillingParamsChecks, FaultsAreListedTogether) {
  FillingParams params = sound();
  params.material.density = -1;
  params.gates[0].position = {0.5, 0.5, 0.1};
  params.numerics.layers = 7;
  EXPECT_EQ(complaint(params),
            "material.density = -1: it is not positive: give a number above zero\n"
            "gates.position = gate: it lies 100 mm off the part: move it onto the middle "
            "surface of the part\n"
            "numerics.layers = 7: so many layers cannot be computed: take an even number from 4 to 128");
}

TEST(FillingParamsChecks, ACavityThatCannotFillIsRefused) {
  FillingParams params = sound();
  params.gates[0].intervals[0].opens = {TriggerKind::time, 1};
  EXPECT_NE(complaint(params).find("none is open at the start"), std::string::npos);
  params.gates.clear();
  EXPECT_NE(complaint(params).find("place at least one gate"), std::string::npos);
  params = sound();
  params.material.no_flow_temperature = 600;
  EXPECT_NE(complaint(params).find("stands still"), std::string::npos);
  params = sound();
  const double steep[] = {25000, 0.3, 4e12, 263.15, 0, 1e6, 51.6};  // exp(-8e5) Pa s
  params.material.viscosity = make_viscosity_law("cross_wlf", steep);
  EXPECT_NE(complaint(params).find("so many Pa s has the melt at 10 1/s and 500 K"), std::string::npos);
  params = sound();
  params.process.flow.rows.clear();
  EXPECT_NE(complaint(params).find("give at least one flow rate"), std::string::npos);
  params.process.flow = {{{0, 1e-6}, {0, 2e-6}}};
  EXPECT_NE(complaint(params).find("do not rise"), std::string::npos);
}

TEST(FillingParamsChecks, AMeshThatCannotShowAFrontIsRefused) {
  try {
    check_params(sound(), square());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "mesh: its 2 triangles are too few: no node is more than 1 edges from a gate: mesh the part so "
        "that melt passes 4 edges and more on its longest way, better 20");
  }
}

TEST(FillingParamsChecks, EventsOfAGateMustFollowEachOther) {
  const auto told = [](std::vector<OpenInterval> intervals) {
    FillingParams params = sound();
    params.sensors = {{"S1", {0.5, 0.5, 0}}};
    params.gates.push_back(params.gates[0]);
    params.gates[1].name = "valve";
    params.gates[1].intervals = std::move(intervals);
    return complaint(params);
  };
  using enum TriggerKind;
  EXPECT_EQ(told({{{filled_fraction, 0.2}, {time, 1}}, {{arrival, 0, 0}, {filled_fraction, 0.5}}}), "");
  EXPECT_EQ(told({{{start}, {filled_fraction, 0.5}}, {{filled_fraction, 0.5}}}),
            "gates.events = valve: event 3, filled 0.5, does not come after event 2, filled 0.5: sort the "
            "events: "
            "opens, closes, opens again, ...");
  EXPECT_NE(told({{{start}, {time, 0}}}).find("time 0 s, does not come after event 1, start"),
            std::string::npos);
  EXPECT_NE(told({{{arrival, 0.1, 0}, {arrival, 0.1, 0}}}).find("arrival at S1 0.1 s, does not come after"),
            std::string::npos);
  EXPECT_NE(told({{{start}, {never}}, {{time, 1}}}).find("follows one that never comes"), std::string::npos);
  EXPECT_NE(told({{{time, 1}, {time, 2}}, {{start}}}).find("comes after another event"), std::string::npos);
  EXPECT_NE(told({{{filled_fraction, 1.5}}}).find("filled 1.5 is out of range"), std::string::npos);
  EXPECT_NE(told({{{arrival, 0, 3}}}).find("there is no sensor number 3"), std::string::npos);
}

TEST(FillingParamsChecks, SensorsLieOnThePart) {
  FillingParams params = sound();
  params.sensors = {{"S1", {0.5, 0.5, 0.01}}};
  EXPECT_NE(complaint(params).find("sensors.position = S1: it lies 10 mm off the part"), std::string::npos);
}

TEST(FillingParamsChecks, FibersMustFitTheirClasses) {
  FillingParams params = sound();
  const double values[] = {1, 0.01, 2e9, 19e-6};
  params.fibers.length_sets = {{"a", make_attrition_law("unbreakable_length", values)}};
  EXPECT_NE(complaint(params).find("at least one initial length"), std::string::npos);
  params.fibers.class_lengths = {0.01, 0.02};
  EXPECT_EQ(complaint(params), "");
  params.fibers.inlet.lengths = {0.01};
  EXPECT_NE(complaint(params).find("1 lengths for 2 classes"), std::string::npos);
  params.fibers.inlet.lengths.clear();
  params.fibers.inlet.numbers = {1, 2};
  EXPECT_NE(complaint(params).find("give one number a class, here and for all gates"), std::string::npos);
  params.fibers.class_numbers = {1, 1};
  EXPECT_EQ(complaint(params), "");
  params.fibers.inlet.numbers = {0, 0};
  EXPECT_NE(complaint(params).find("none is positive"), std::string::npos);
  params = sound();
  params.fibers.inlet.orientation = Vec3(1.2, -0.1, -0.1).asDiagonal();
  EXPECT_NE(complaint(params).find("fibers.inlet.orientation"), std::string::npos);
  params = sound();
  params.fibers.coupling = FiberCoupling{};
  EXPECT_NE(complaint(params).find("needs the orientation"), std::string::npos);
  params = sound();
  const double phelps[] = {0.01, 3, 0.25, 73e9, 19e-6, 0};
  params.fibers.length_sets = {{"p", make_attrition_law("phelps", phelps)}};
  params.fibers.class_lengths = {0.01};
  EXPECT_NE(complaint(params).find("needs a length distribution"), std::string::npos);
}

TEST(FlowProfile, HoldsOrRampsBetweenRows) {
  FlowProfile profile{{{0, 1}, {2, 3}}, ProfileAgainst::time, ProfileForm::steps};
  EXPECT_EQ(profile.at(1.9, 0), 1);
  EXPECT_EQ(profile.at(2, 0), 3);
  EXPECT_EQ(profile.at(9, 0), 3);
  EXPECT_EQ(profile.next_row(0), 2);
  EXPECT_TRUE(std::isinf(profile.next_row(2)));
  profile.form = ProfileForm::ramps;
  EXPECT_NEAR(profile.at(1, 0), 2, 1e-15);
  profile.against = ProfileAgainst::filled_fraction;
  EXPECT_NEAR(profile.at(1, 0.5), 1.5, 1e-15);
  EXPECT_NEAR(flow_of_ram(profile, 2).rows[1].rate, 3 * std::numbers::pi, 1e-14);
}

TEST(GateNodes, AreThoseWithinTheRadiusOrTheNearest) {
  const ShellMesh mesh = square();
  Gate gate;
  gate.position = {0.9, 0.1, 0};
  EXPECT_EQ(nodes_of(gate, mesh), (std::vector<Index>{1}));
  gate.position = {0, 0, 0};
  gate.end = Vec3(0, 1, 0);
  EXPECT_EQ(nodes_of(gate, mesh), (std::vector<Index>{0, 3}));
  EXPECT_NEAR(distance_from_part(gate, mesh), 0, 1e-15);
  gate.end = Vec3(0, 1, 0.25);
  EXPECT_NEAR(distance_from_part(gate, mesh), 0.25, 1e-15);
}

}  // namespace
}  // namespace fiberfate
