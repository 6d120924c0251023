// Threads change nothing, and fibers that the flow feels do what they should.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "full_filling.hpp"
#include "same_state.hpp"

namespace fiberfate {
namespace {

using namespace test;

TEST(FillingInvariance, ThreadsGiveTheSameBits) {
  const int before = thread_count();
  Filling one{ShellMesh(plaque()), full_params()}, three{ShellMesh(plaque()), full_params()};
  while (!one.finished()) {
    use_threads(1);
    one.advance();
    use_threads(3);
    three.advance();
  }
  use_threads(before);
  expect_same(one.state(), three.state());
  EXPECT_EQ(one.state().stop_reason, FillingEnd::filled);
}

TEST(FillingInvariance, AForeignStateIsRefused) {
  Filling filling{ShellMesh(plaque()), full_params()};
  FillingParams other = full_params();
  other.numerics.layers = 10;
  EXPECT_THROW(Filling(ShellMesh(plaque()), other, filling.state()), InputError);
  const auto complaint = [](const FillingState& state) -> std::string {
    try {
      Filling(ShellMesh(plaque()), full_params(), state);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint(filling.state()), "");
  FillingState state = filling.state();
  state.filled.pop_back();
  state.rate[7] = -1;
  state.gates[1].moves = 9;
  state.mark[0] = static_cast<NodeMark>(77);
  const std::string told = complaint(state);
  for (const char* part : {"state/filled: 285 values where 286 belong", "state/rate: value 7 is -1",
                           "state/gates: gate 1 cannot have moved 9 times",
                           "state/mark: there are no such marks", "from a checkpoint that is whole"})
    EXPECT_NE(told.find(part), std::string::npos) << part << "\nin\n" << told;
}

/// Fibers raise the viscosity in shear by 1 + R (D:A4:D)/(D:D): with isotropic fibers, 2/15 of the squared
/// rate of strain, so an orientation that stays isotropic multiplies all pressures by 1 + 2 phi N_p/15.
TEST(FiberCouplingInFlow, IsotropicFibersMultiplyThePressure) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  FillingParams params = isothermal(1e-6, viscosity("newtonian", {100}), film_gate({0, 0, 0}, {0, 0.01, 0}));
  OrientationModel model = orientation_model_named("folgar_tucker", "linear");  // exact for isotropic states
  model.constants.c_i = 1;
  model.constants.xi = 0;
  params.fibers.orientation = model;
  Filling plain{ShellMesh(rectangle(r)), params};
  params.fibers.coupling = FiberCoupling{0.1, 19e-6, -1, 0, 100};
  Filling coupled{ShellMesh(rectangle(r)), params};
  while (plain.filled_fraction() < 0.8) {
    plain.advance();
    coupled.advance();
  }
  const double particles = 100.0 * 100 / (3 * 0.5 * std::log(std::numbers::pi / 0.1));
  // The nodes next to the front follow a step later.
  EXPECT_NEAR(coupled.state().sprue_pressure / plain.state().sprue_pressure, 1 + 0.1 * particles * 2 / 15,
              0.05 * 0.1 * particles * 2 / 15);
}

/// Isotropic fibers raise the viscosity everywhere by one factor F, so that the velocities stay those of the
/// plain melt. Lengths then are those in a plain melt of the matrix' viscosity, or of F times that where the
/// suspension drags; half the term R gives 1 + (F - 1)/2.
TEST(FiberCouplingInFlow, LengthsFeelTheViscosityThatIsChosen) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  const double values[] = {0.5, 0.02, 2e9, 19e-6};
  const auto length_after = [&](double eta, std::optional<FiberCoupling> coupling) {
    FillingParams params =
        isothermal(1e-6, viscosity("newtonian", {eta}), film_gate({0, 0, 0}, {0, 0.01, 0}));
    params.fibers.class_lengths = {0.0015};
    params.fibers.length_sets = {{"xi", make_attrition_law("unbreakable_length", values)}};
    OrientationModel model = orientation_model_named("folgar_tucker", "linear");
    model.constants.c_i = 0;  // without diffusion and stretching an isotropic state stays
    model.constants.xi = 0;
    params.fibers.orientation = model;
    params.fibers.coupling = coupling;
    Filling filling{ShellMesh(rectangle(r)), params};
    filling.run_to_end();
    return filling.mean_lengths_of(0, filling.mesh().nearest_node({0.04, 0.005, 0}))[0];
  };
  FiberCoupling coupling{0.1, 19e-6, -1, 0, 100};
  const double term = 0.1 * 100.0 * 100 / (3 * 0.5 * std::log(std::numbers::pi / 0.1)) * 2 / 15;
  const double plain = length_after(100, {});
  EXPECT_NEAR(length_after(100, coupling), plain, 1e-3 * plain);
  coupling.drag = DragViscosity::suspension;
  const double dragged = length_after(100 * (1 + term), {});
  EXPECT_LT(dragged, 0.9 * plain);
  // The front follows a step later.
  EXPECT_NEAR(length_after(100, coupling), dragged, 0.01 * plain);
  coupling.scale = 0.5;
  EXPECT_NEAR(length_after(100, coupling), length_after(100 * (1 + term / 2), {}), 0.01 * plain);
}

/// Aligned fibers in shear along them are not stretched: pressure falls from isotropic towards plain melt.
TEST(FiberCouplingInFlow, AlignmentLowersThePressure) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  FillingParams params = isothermal(1e-6, viscosity("newtonian", {100}), film_gate({0, 0, 0}, {0, 0.01, 0}));
  OrientationModel model = orientation_model_named("folgar_tucker", "ibof");
  model.constants.c_i = 0.003;
  params.fibers.orientation = model;
  params.fibers.coupling = FiberCoupling{0.1, 19e-6, -1, 0, 100};
  Filling random{ShellMesh(rectangle(r)), params};
  params.fibers.inlet.orientation = Vec3(0.98, 0.01, 0.01).asDiagonal();
  Filling aligned{ShellMesh(rectangle(r)), params};
  while (random.filled_fraction() < 0.5) {
    random.advance();
    aligned.advance();
  }
  EXPECT_LT(aligned.state().sprue_pressure, random.state().sprue_pressure);
}

}  // namespace
}  // namespace fiberfate
