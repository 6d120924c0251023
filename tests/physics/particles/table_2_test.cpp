// The case of the thesis' tables 1 and 2: 138 short fibers orient alike with the adaptive and a converged
// fixed step.
#include <gtest/gtest.h>

#include "fibers/observables.hpp"
#include "scenes.hpp"

namespace fiberfate {
namespace {

constexpr double duration = 0.1;  // s

/// 138 fibers of 0.25 mm, 10 % by weight: 3.8 % by volume with glass of 2550 and polypropylene of 905 kg/m³.
FiberState cluster() {
  const double fraction = (0.1 / 2550) / (0.1 / 2550 + 0.9 / 905);
  const double volume = 138 * pi * scenes::glass.radius * scenes::glass.radius * 0.25e-3 / fraction;
  return scenes::scatter({.fibers = 138, .length = 0.25e-3, .rods = 5, .cell = std::cbrt(volume), .seed = 2});
}

/// a11 at 50 equal intervals.
std::vector<double> orientation(const DynamicsParameters& parameters) {
  Simulation simulation(parameters, FlowHistory::constant(scenes::couette_rate, scenes::melt_viscosity),
                        cluster());
  std::vector<double> a11;
  for (int i = 1; i <= 50; ++i) {
    scenes::run_until(simulation, i * duration / 50);
    a11.push_back(orientation_tensor(simulation.state(), Weighting::length)(0, 0));
  }
  return a11;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(Table2, AdaptiveStepAgreesWithAConvergedFixedStep) {
  const auto converged = orientation(scenes::fixed_step(1e-5));
  EXPECT_LT(largest_difference(converged, orientation(scenes::fixed_step(2e-5))), 1e-3) << "not converged";
  DynamicsParameters adaptive;
  adaptive.step.initial = 1e-5;
  EXPECT_LT(largest_difference(converged, orientation(adaptive)), 5e-3);
  EXPECT_GT(converged.back() - converged.front(), 0.05) << "nothing turned";
}

}  // namespace
}  // namespace fiberfate
