// Starts the dynamics from packings: they stay where no flow moves them, and hardly break when sheared.
#include <gtest/gtest.h>

#include "dynamics/simulation.hpp"
#include "fibers/observables.hpp"
#include "packing/packing.hpp"

namespace fiberfate {
namespace {

/// Fibers of 2.5 mm of the Couette study in a smaller cube.
PackingRequest couette_request(int count, double volume_fraction) {
  FiberSpecies species;
  species.material = {9.5e-6, 73e9, 2550};
  species.length = SingleLength{2.5e-3};
  species.rod_length = 0.1e-3;
  ConcentrationRequest amount;
  amount.count = count;
  amount.volume_fraction = volume_fraction;
  const Population population = plan_population({species}, amount, 1);
  PackingRequest request;
  request.materials = population.materials;
  request.fibers = population.fibers;
  request.cell = rectangular_cell(population.cell_size);
  return request;
}

Simulation simulate(const FiberState& state, double rate, double until) {
  DynamicsParameters parameters;
  parameters.breakage.law = "fixed";
  parameters.breakage.critical_radius = 300e-6;
  Simulation simulation(parameters, FlowHistory::constant(rate, 200), state);
  while (simulation.state().time < until) static_cast<void>(simulation.advance(until));
  return simulation;
}

// 30 % by weight: every contact has room to carry what the bent fibers press.
TEST(PackingStartUp, APackingStaysWhereNothingFlows) {
  PackingRequest request = couette_request(40, volume_from_weight_fraction(0.3, 2550, 905));
  request.minimum_radius = 1.2e-3;
  for (const Vec3& orientation : {Vec3(Vec3::Constant(1.0 / 3)), Vec3(0.6, 0.3, 0.1)}) {
    request.orientation.tensor = orientation.asDiagonal();
    const PackingResult packed = pack(request);
    EXPECT_GE(packed.report.minimum_radius, 1.2e-3);
    EXPECT_LT(packed.report.orientation_error, 0.005);
    Simulation still = simulate(packed.state, 0, 0.01);
    const ContactStatistics contacts = still.contact_statistics();
    EXPECT_LT(0.5 * contacts.max_overlap, 0.02);
    EXPECT_LT(0.5 * contacts.mean_overlap, 0.01);
    EXPECT_EQ(still.state().breaks, 0);
  }
}

TEST(PackingStartUp, BundlesStayAt21PercentByVolume) {
  PackingRequest request = couette_request(57, 0.209);
  request.start = PackingStart::bundles;
  Simulation still = simulate(pack(request).state, 0, 0.01);
  EXPECT_LT(0.5 * still.contact_statistics().max_overlap, 0.02);
}

// From relaxed straight fibers a third of the length is lost in 10 ms.
TEST(PackingStartUp, LosesLessThanFivePercentOfLengthIn50Milliseconds) {
  const PackingResult packed = pack(couette_request(150, 0.209));
  const Simulation sheared = simulate(packed.state, 16.65, 0.05);
  EXPECT_GT(mean_lengths(sheared.state()).number_average, 0.95 * 2.5e-3);
}

}  // namespace
}  // namespace fiberfate
