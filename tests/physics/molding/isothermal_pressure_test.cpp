// Compares the pressure of isothermal filling with exact solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "molding/mesh_quality.hpp"
#include "physics/record.hpp"
#include "test_shells.hpp"

namespace fiberfate {
namespace {

using namespace test;

/// Root mean square of (computed - exact) over all steps, over the largest exact pressure; `exact` takes the
/// volume that has been injected.
double pressure_error(Filling& filling, const std::function<double(double)>& exact) {
  double squares = 0, largest = 0, injected = 0;
  int count = 0;
  fill(filling, [&] {
    // The pressure belongs to the volume at the beginning of the step.
    const double volume = std::exchange(injected, filling.state().injected_volume);
    if (volume == 0 || filling.state().flow_rate == 0) return;
    const double wanted = exact(volume);
    squares += std::pow(filling.state().sprue_pressure - wanted, 2);
    largest = std::max(largest, wanted);
    ++count;
  });
  EXPECT_EQ(filling.state().stop_reason, FillingEnd::filled);
  EXPECT_NEAR(filling.state().injected_volume / filling.mesh().total_volume(), 1, 1e-10);
  EXPECT_NEAR(filling.filled_fraction(), 1, 1e-10);
  return std::sqrt(squares / count) / largest;
}

constexpr double rate = 1e-6;  // m³/s

/// Newtonian flow in a strip at constant rate: p(t) = 12 eta Q x/(W H³) with x = V/(W H).
double strip_error(const Rectangle& r, const std::function<Vec3(const Vec3&)>& place = {}) {
  const double eta = 100;
  const auto at = [&](const Vec3& x) { return place ? place(x) : x; };
  const Gate gate = film_gate(at({0, 0, 0}), at({0, r.width, 0}));
  Filling filling(ShellMesh(rectangle(r, place)), isothermal(rate, viscosity("newtonian", {eta}), gate));
  return pressure_error(filling, [&](double volume) {
    return 12 * eta * rate * volume / (std::pow(r.width, 2) * std::pow(r.thickness, 4));
  });
}

/// Power-law flow: p = (2 K x/H) (2 (2n+1)/n · Q/(W H²))^n.
double power_law_error(int layers, int along) {
  const double consistency = 1000, n = 0.35;
  Rectangle r;
  r.along = along;
  FillingParams params =
      isothermal(rate, viscosity("power_law", {consistency, n, 1e-3}), film_gate({0, 0, 0}, {0, r.width, 0}));
  params.numerics.layers = layers;
  Filling filling(ShellMesh(rectangle(r)), params);
  return pressure_error(filling, [&](double volume) {
    const double x = volume / (r.width * r.thickness);
    const double wall_rate = 2 * (2 * n + 1) / n * rate / (r.width * r.thickness * r.thickness);
    return 2 * consistency * x / r.thickness * std::pow(wall_rate, n);
  });
}

/// Newtonian flow from a gate of radius r_0 in the middle of a disc: p = (6 eta Q/(pi H³)) ln(R/r_0); the
/// gate is a hole when `hole`, else nodes of the mesh, or a single node where the mesh is coarser than it.
double disc_error(double size, double gate_radius, bool hole) {
  const double eta = 100, thickness = 0.002;
  Gate gate;
  gate.radius = gate_radius * (1 + 1e-9);
  const double inner = hole ? gate_radius : 0;
  Filling filling(ShellMesh(disc(inner, 0.1, size, thickness)),
                  isothermal(1e-5, viscosity("newtonian", {eta}), gate));
  return pressure_error(filling, [&](double volume) {
    const double front = std::sqrt(inner * inner + volume / (std::numbers::pi * thickness));
    return 6 * eta * 1e-5 / (std::numbers::pi * std::pow(thickness, 3)) * std::log(front / gate_radius);
  });
}

TEST(IsothermalPressure, StripConvergesWithFirstOrderOrBetter) {
  Rectangle r;
  r.along = 40;
  const double coarse = strip_error(r);
  r.along = 80;
  const double fine = strip_error(r);
  record("rms error of the pressure over the largest, strip of 80 cells", 0, fine, 0.002);
  EXPECT_LT(fine, coarse / 2);
}

/// A strip whose rows of triangles lean over by `shear` cells a row; `bump` lifts its nodes out of the plane
/// by a share of a cell, so that no pair of triangles is flat and no edge can be turned.
Shell leaning_strip(const Rectangle& r, double shear, double bump) {
  Shell shell = rectangle(r, [&](const Vec3& x) {
    const double cell = r.length / r.along, row = x[1] / r.width * r.across - 0.5 * r.across;
    const double room = std::min({1.0, x[0] / (shear * r.across * cell + 1e-12),
                                  (r.length - x[0]) / (shear * r.across * cell + 1e-12)});
    const double up = std::sin(7919 * x[0] / cell + 104729 * row);
    return Vec3(x[0] + shear * cell * row * room, x[1], bump * cell * up * room);
  });
  return shell;
}

/// A mesh far from Delaunay is as good as another, since the flow turns its edges; where walls are not flat
/// they stay, and what they cut off tells how wrong the pressure is.
TEST(IsothermalPressure, ObtuseTrianglesAreTurnedOrRefused) {
  const Rectangle r{0.08, 0.02, 0.002, 40, 10};
  const auto error_of = [&](const Shell& shell) {
    Filling filling(ShellMesh(shell),
                    isothermal(rate, viscosity("newtonian", {100}), film_gate({0, 0, 0}, {0, r.width, 0})));
    return pressure_error(filling, [&](double volume) {
      return 12 * 100 * rate * volume / (std::pow(r.width, 2) * std::pow(r.thickness, 4));
    });
  };
  EXPECT_LT(error_of(leaning_strip(r, 0, 0)), 0.002);
  for (const double shear : {0.5, 1.0, 2.0}) {
    EXPECT_GT(ShellMesh(leaning_strip(r, shear, 0)).turned_edges(), 100u);
    EXPECT_LT(error_of(leaning_strip(r, shear, 0)), 0.002) << shear;
  }
  EXPECT_THROW(error_of(leaning_strip(r, 2, 0.05)), InputError);
}

/// Rows that zigzag have obtuse triangles at the rim, whose edges no turning mends: without a weight of their
/// own, flow along the wall still meets the right resistance.
TEST(IsothermalPressure, ObtuseTrianglesAtWallsCostLittle) {
  struct Zigzag {
    int along, across;
    double error;
  };
  for (const auto& [along, across, error] :
       {Zigzag{80, 40, 0.005}, Zigzag{40, 40, 0.005}, Zigzag{20, 80, 0.02}}) {
    Rectangle r{0.2, 0.02, 0.002, along, across};
    const auto shifted = [&](const Vec3& x) {
      const bool odd = std::lround(x[1] / r.width * across) % 2 == 1,
                 inside = x[0] > 1e-9 && x[0] < r.length - 1e-9;
      return Vec3(x[0] + (odd && inside ? 0.45 * r.length / along : 0), x[1], 0);
    };
    EXPECT_GT(ShellMesh(rectangle(r, shifted)).cut_off(), 1e-3);
    EXPECT_LT(strip_error(r, shifted), error) << along << " x " << across;
  }
}

/// What a coarse mesh costs: MeshQuality says it to a factor of 1.5.
TEST(IsothermalPressure, QualityTellsTheErrorOfCoarseStrips) {
  for (const int along : {4, 6, 10, 20, 40}) {
    Rectangle r;
    r.along = along;
    r.across = 2;
    r.width = 2 * r.length / along;
    const Gate gate = film_gate({0, 0, 0}, {0, r.width, 0});
    const MeshQuality quality = quality_of(ShellMesh(rectangle(r)), std::span(&gate, 1));
    EXPECT_EQ(quality.reach, static_cast<std::size_t>(along));
    EXPECT_EQ(quality.cut_off, 0);
    EXPECT_NEAR(std::log(strip_error(r) / quality.pressure_error()), 0, std::log(1.5)) << along;
  }
  Rectangle r;
  r.along = 3;
  EXPECT_THROW(strip_error(r), InputError);
}

TEST(IsothermalPressure, StripBentInSpaceIsTheSameStrip) {
  // Bent over an edge and around a cylinder: lengths along the surface stay, to the chords of the cylinder.
  const double radius = 0.02;
  const auto bent = [&](const Vec3& x) {
    if (x[0] < 0.04) return Vec3(x[0], x[1], 0);
    const double angle = (x[0] - 0.04) / radius;
    return Vec3(0.04 + radius * std::sin(angle), x[1], radius * (1 - std::cos(angle)));
  };
  EXPECT_LT(strip_error({}, bent), 0.002);
  const auto folded = [&](const Vec3& x) {
    return x[0] < 0.04 ? Vec3(x[0], x[1], 0) : Vec3(0.04, x[1], x[0] - 0.04);
  };
  EXPECT_NEAR(strip_error({}, folded), strip_error({}), 1e-9);
}

TEST(IsothermalPressure, TurnedStripIsTheSameStrip) {
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const double turned = strip_error({}, [&](const Vec3& x) { return Vec3(turn * x + Vec3(1, 0, 2)); });
  // Round-off decides which of equal nodes fills last.
  EXPECT_NEAR(turned, strip_error({}), 1e-5);
}

TEST(IsothermalPressure, PowerLawStrip) {
  const double error = power_law_error(20, 80);
  record("rms error of the pressure over the largest, power law n = 0.35, 20 layers", 0, error, 0.002);
  // With half the layers the error is that of the gap's profile: second order in their width.
  EXPECT_LT(error, power_law_error(10, 80) / 2.5);
}

TEST(IsothermalPressure, DiscConvergesWithFirstOrderOrBetter) {
  const double coarse = disc_error(0.006, 0.005, true), fine = disc_error(0.003, 0.005, true);
  record("rms error of the pressure over the largest, disc with cells of 3 mm", 0, fine, 0.002);
  EXPECT_LT(fine, coarse / 2);
}

/// Moves the nodes inside of a disc by up to a fifth of a cell, as no structured mesh has them; a generator
/// of our own, so that the mesh is the same everywhere.
Shell shaken(Shell shell, double size, double outer) {
  std::uint32_t number = 1;
  const auto next = [&number] {
    number = 1664525 * number + 1013904223;
    return number / 4294967296.0 - 0.5;
  };
  for (Vec3& x : shell.nodes)
    if (x.norm() > 1e-9 && x.norm() < outer - 1e-6) x += 0.4 * size * Vec3(next(), next(), 0);
  return shell;
}

/// Round gates of about the mesh size hold some of the nodes around and not others: each edge that leaves the
/// gate carries what passes its dual face in the radial field, so that the front stays round and the pressure
/// does not rise before the rim is full: a front off the middle would reach one side long before the other.
TEST(IsothermalPressure, RoundGatesOfTheMeshSizeStayRound) {
  const double eta = 100, thickness = 0.002, outer = 0.1, size = 0.004;
  for (const double radius : {0.0012, 0.0035, 0.004, 0.0045, 0.005, 0.006}) {
    Gate gate;
    gate.radius = radius;
    Filling filling(ShellMesh(shaken(disc(0, outer, size, thickness), size, outer)),
                    isothermal(1e-5, viscosity("newtonian", {eta}), gate));
    double greatest = 0;
    const double exact =
        6 * eta * 1e-5 / (std::numbers::pi * std::pow(thickness, 3)) * std::log(outer / radius);
    fill(filling, [&] {
      // The last few nodes of the rim take the whole flow, which is no longer radial (up to 3.7 %).
      if (filling.filled_fraction() < 0.998) greatest = std::max(greatest, filling.state().sprue_pressure);
    });
    // Half a cell at the rim, where p = 0 is taken to lie, is ln(1 + 0.02), 0.7 % of the logarithm.
    EXPECT_NEAR(greatest / exact, 1, 0.01) << radius;
  }
}

/// The few nodes that are free at last would ask for up to four times the pressure here, whatever the mesh:
/// what is shown stays that of the front when it was whole, and within 2 % of the exact pressure.
TEST(IsothermalPressure, TheLastMeltAsksForNoPressureOfItsOwn) {
  const double outer = 0.1, size = 0.004, thickness = 0.002, radius = 0.005;
  Gate gate;
  gate.radius = radius;
  Filling filling(ShellMesh(disc(0, outer, size, thickness)),
                  isothermal(2e-5, viscosity("newtonian", {100}), gate));
  fill(filling, [&] {
    const FillingState& state = filling.state();
    const double greatest = *std::max_element(state.pressure.begin(), state.pressure.end());
    EXPECT_LE(greatest, state.sprue_pressure * (1 + 1e-12)) << state.steps;
    EXPECT_LE(state.gates[0].pressure, state.sprue_pressure * (1 + 1e-12)) << state.steps;
    EXPECT_EQ(state.flow_rate, 2e-5);
  });
  const double exact =
      6 * 100 * 2e-5 / (std::numbers::pi * std::pow(thickness, 3)) * std::log(outer / radius);
  EXPECT_NEAR(filling.state().sprue_pressure / exact, 1, 0.02);
  EXPECT_NEAR(filling.state().time, filling.mesh().total_volume() / 2e-5, 1e-9);
}

TEST(IsothermalPressure, GateKeepsItsSizeOnAnyMesh) {
  // The gate holds one node (0.3 of a cell), seven nodes, or less than the mesh resolves. 0.5 % of the
  // largest pressure is a fiftieth of what a change of the gate's radius by half would make.
  const std::string name = "rms error of the pressure over the largest, disc with a gate of ";
  record(name + "1.2 mm, cells of 4 mm", 0, disc_error(0.004, 0.0012, false), 0.002);
  record(name + "4 mm, cells of 3 mm", 0, disc_error(0.003, 0.004, false), 0.002);
  record(name + "0.1 mm, cells of 4 mm", 0, disc_error(0.004, 0.0001, false), 0.002);
}

}  // namespace
}  // namespace fiberfate
