// Compares the pressure of isothermal filling with exact solutions.
#include <gtest/gtest.h>

#include "test_shells.hpp"

namespace fiberfate {
namespace {

using namespace test;

/// Root mean square of (computed - exact) over all steps, over the largest exact pressure. `exact` takes the
/// injected volume.
double pressure_error(Filling& filling, const std::function<double(double)>& exact) {
  double squares = 0, largest = 0;
  int count = 0;
  while (!filling.finished()) {
    // The pressure belongs to the volume at the beginning of the step.
    const double volume = filling.state().injected_volume;
    filling.advance();
    if (volume == 0) continue;
    const double wanted = exact(volume);
    squares += std::pow(filling.state().sprue_pressure - wanted, 2);
    largest = std::max(largest, wanted);
    ++count;
  }
  EXPECT_EQ(filling.state().stop_reason, StopReason::filled);
  return std::sqrt(squares / count) / largest;
}

/// p(t) = 12 eta Q x/(W H³), x = V/(W H).
double strip_error(const Rectangle& r, const std::function<Vec3(const Vec3&)>& place = {}) {
  const double rate = 1e-6, eta = 100;
  const auto at = [&](const Vec3& x) { return place ? place(x) : x; };
  Filling filling(ShellMesh(rectangle(r, place)),
                  isothermal(rate, viscosity("newtonian", {eta}), film_gate(at({0, 0, 0}), at({0, r.width, 0}))));
  return pressure_error(filling, [&](double volume) {
    return 12 * eta * rate * volume / (std::pow(r.width, 2) * std::pow(r.thickness, 4));
  });
}

TEST(IsothermalPressure, StripAtConstantRate) {
  Rectangle r;
  for (int along : {20, 40, 80, 160}) {
    r.along = along;
    printf("strip %d: %g\n", along, strip_error(r));
  }
}

TEST(IsothermalPressure, PowerLawStrip) {
  Rectangle r;
  for (int layers : {10, 20, 40}) for (int along : {40,80}) {
    r.along = along;
    const double rate = 1e-6, K = 1000, n = 0.35;
    auto params = isothermal(rate, viscosity("power_law", {K, n, 1e-3}), film_gate({0, 0, 0}, {0, r.width, 0}));
    params.numerics.layers = layers;
    Filling filling(ShellMesh(rectangle(r)), params);
    double e = pressure_error(filling, [&](double volume) {
      const double x = volume / (r.width * r.thickness);
      return 2 * K * x / r.thickness * std::pow(2 * (2 * n + 1) / n * rate / (r.width * r.thickness * r.thickness), n);
    });
    printf("power %d layers %d: %g steps %ld\n", along, layers, e, filling.state().steps);
  }
}

TEST(IsothermalPressure, Disc) {
  for (double size : {0.006, 0.003, 0.0015}) {
    const double rate = 1e-5, eta = 100, H = 0.002, r0 = 0.005;
    Gate gate;
    gate.radius = r0 * (1 + 1e-9);
    auto params = isothermal(rate, viscosity("newtonian", {eta}), gate);
    Filling filling(ShellMesh(disc(r0, 0.1, size, H)), params);
    double e = pressure_error(filling, [&](double volume) {
      const double R = std::sqrt(r0 * r0 + volume / (std::numbers::pi * H));
      return 6 * eta * rate / (std::numbers::pi * H * H * H) * std::log(R / r0);
    });
    for (auto ph : {FillingPhase::flow, FillingPhase::front, FillingPhase::heat, FillingPhase::lengths, FillingPhase::orientation}) printf("%g ", filling.seconds(ph));
    printf("disc %g: %g nodes %zu steps %ld vol %g\n", size, e, filling.mesh().node_count(), filling.state().steps, filling.state().injected_volume/filling.mesh().total_volume()-1);
  }
}

}  // namespace
}  // namespace fiberfate
