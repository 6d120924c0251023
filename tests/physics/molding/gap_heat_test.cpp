// Compares conduction across the gap and viscous heating with theory.
#include <gtest/gtest.h>

#include "test_shells.hpp"

namespace fiberfate {
namespace {

using namespace test;

constexpr double inlet = 500, mold = 320;

FillingParams heated(double rate, double consistency, const Rectangle& r) {
  FillingParams params =
      isothermal(rate, viscosity("newtonian", {consistency}), film_gate({0, 0, 0}, {0, r.width, 0}));
  params.material.density = 1000;
  params.material.heat_capacity = 2000;
  params.material.conductivity = 0.2;
  params.process.inlet_temperature = inlet;
  params.process.mold_temperature = mold;
  params.numerics.heat = HeatModel::full;
  return params;
}

/// Melt that came to rest at uniform temperature cools by
///   (T - T_mold)/(T_0 - T_mold) = sum over odd m of 4/(m pi) sin(m pi/2) cos(m pi zeta/2) exp(-m² pi² Fo/4),
/// Fo = a t/(H/2)².
double cooling(double zeta, double fourier_number) {
  double sum = 0;
  for (int m = 1; m < 400; m += 2) {
    const double decay = std::exp(-m * m * std::numbers::pi * std::numbers::pi * fourier_number / 4);
    sum += 4 / (m * std::numbers::pi) * std::sin(m * std::numbers::pi / 2) *
           std::cos(m * std::numbers::pi * zeta / 2) * decay;
  }
  return sum;
}

/// The gate's row of nodes, fed once and then cut off by a gate that closes: the melt next to it stands.
TEST(GapHeat, MeltAtRestCoolsByConduction) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  FillingParams params = heated(1e-4, 1e-3, r);  // 16 ms to fill: Fo = 1.6e-3 while it moves
  Gate far = film_gate({r.length, 0, 0}, {r.length, r.width, 0});
  far.intervals[0].opens = {TriggerKind::filled_fraction, 0.99};
  params.gates[0].intervals[0].closes = {TriggerKind::filled_fraction, 0.99};
  params.gates.push_back(far);
  params.process.flow = {{{0, 1e-4}, {0.99, 1e-8}}, ProfileAgainst::filled_fraction, ProfileForm::steps};
  params.numerics.layers = 40;
  params.numerics.steps = 2000;  // of 0.08 s each, at the slow rate: the implicit step is of first order
  Filling filling{ShellMesh(rectangle(r)), params};
  filling.run_to_end();
  const std::size_t node = filling.mesh().nearest_node({0.02, 0.005, 0}), layers = filling.layers().count();
  for (const std::size_t k : {std::size_t{0}, layers / 2, layers - 3}) {
    const double fourier_number = 1e-7 * filling.state().time / 1e-6;
    const double wanted = cooling(filling.layers().middles()[k], fourier_number);
    const double found = (filling.state().temperature[node * layers + k] - mold) / (inlet - mold);
    // The implicit step is of first order: 0.024, 0.014, 0.006, 0.003 off with 500, 1000, 2000, 4000 steps,
    // whatever the layers.
    EXPECT_NEAR(found, wanted, 0.007);
  }
}

/// In steady flow without conduction the mixed temperature rises by p/(rho c) on the way from the gate.
TEST(GapHeat, ViscousHeatingIsThePressureDrop) {
  const Rectangle r{0.08, 0.01, 0.002, 40, 2};
  FillingParams params = heated(2e-5, 2000, r);
  params.material.conductivity = 1e-9;
  params.process.mold_temperature = inlet;
  Filling filling{ShellMesh(rectangle(r)), params};
  filling.run_to_end();
  const HeatAccount& heat = filling.state().heat;
  // Work = int p Q dt with p = 12 eta Q x/(W H³), so half the last pressure times the volume.
  const double last = 12 * 2000 * 2e-5 * r.length / (r.width * std::pow(r.thickness, 3));
  EXPECT_NEAR(heat.dissipated / (last / 2 * filling.mesh().total_volume()), 1, 0.01);
  EXPECT_NEAR(filling.stored_heat(), heat.dissipated, 1e-6 * heat.dissipated);
}

/// Slow film flow far from the gate has a frozen layer whose thickness rises with time of contact; the melt
/// behind a moving front was never colder than at the wall.
TEST(GapHeat, FrozenLayersGrowFromTheWall) {
  const Rectangle r{0.08, 0.01, 0.002, 20, 2};
  FillingParams params = heated(5e-7, 100, r);
  params.material.no_flow_temperature = 400;
  Filling filling{ShellMesh(rectangle(r)), params};
  const std::size_t node = filling.mesh().nearest_node({0.02, 0.005, 0}), layers = filling.layers().count();
  double before = 0;
  for (int part = 1; part <= 3; ++part) {
    while (filling.filled_fraction() < 0.3 * part) filling.advance();
    double frozen = 0;
    for (std::size_t k = 0; k < layers; ++k) {
      const double t = filling.state().temperature[node * layers + k];
      EXPECT_GE(t, mold);
      EXPECT_LE(t, inlet + 5);
      if (t < 400) frozen += filling.layers().widths()[k];
      if (k > 0) {
        EXPECT_LT(t, filling.state().temperature[node * layers + k - 1] + 1e-9);
      }
    }
    EXPECT_GT(frozen, 0);
    EXPECT_GE(frozen, before);  // it is counted in whole layers
    before = frozen;
  }
}

}  // namespace
}  // namespace fiberfate
