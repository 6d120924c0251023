// Times the steps of straight fibers that lie at random.
#include "studies/sample/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/random.hpp"
#include "dynamics/simulation.hpp"
#include "microstructure/orientation_sampling.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

constexpr std::int64_t most_rods = 2000;
constexpr double trial_s = 0.06;
constexpr double time_step = 1e-6;  // s: a moment, so that the crowd stays as it is

/// Takes evenly spread fibers of a population, and a share of its cell.
Population some_of(const Population& population) {
  std::int64_t rods = 0;
  for (const FiberBlank& fiber : population.fibers) rods += fiber.rods;
  const std::size_t every = (rods + most_rods - 1) / most_rods;
  Population some = population;
  some.fibers.clear();
  for (std::size_t i = 0; i < population.fibers.size(); i += every)
    some.fibers.push_back(population.fibers[i]);
  const double share =
      static_cast<double>(some.fibers.size()) / static_cast<double>(population.fibers.size());
  some.cell_size = Vec3::Constant(std::cbrt(share * population.cell_size.prod()));
  return some;
}

FiberState crowd_of(const Population& population, std::uint64_t seed) {
  FiberState state;
  state.materials = population.materials;
  state.cell = rectangular_cell(population.cell_size);
  const std::vector<double> weights(population.fibers.size(), 1.0);
  const std::vector<Vec3> directions = sample_orientations(
      Mat3::Identity() / 3, weights, OrientationDistribution::angular_central_gaussian, seed);
  std::vector<Vec3> nodes;
  for (std::size_t i = 0; i < population.fibers.size(); ++i) {
    const FiberBlank& fiber = population.fibers[i];
    const auto place = uniform4(seed, RandomStream::position, {static_cast<std::uint32_t>(i)});
    const Vec3 begin = Vec3(place[0], place[1], place[2]).cwiseProduct(population.cell_size);
    nodes.clear();
    for (Index k = 0; k <= fiber.rods; ++k)
      nodes.push_back(begin + k * (fiber.length / fiber.rods) * directions[i]);
    append_fiber(state, {nodes, fiber.material_id});
  }
  return state;
}

}  // namespace

double seconds_a_rod_step(const SampleCase& sample, const ContactParameters& contact, std::uint64_t seed) {
  const Population some = some_of(plan_population(species(sample), concentration(sample), seed));
  return seconds_a_rod_step(crowd_of(some, seed), contact);
}

double seconds_a_rod_step(FiberState fibers, const ContactParameters& contact) {
  DynamicsParameters parameters;
  parameters.contact = contact;
  parameters.step.control = StepControl::fixed;
  parameters.step.initial = time_step;
  Simulation simulation(parameters, FlowHistory::constant(1, 100), std::move(fibers));
  simulation.advance(std::numeric_limits<double>::infinity());  // allocates
  const Stopwatch watch;
  std::int64_t steps = 0;
  for (; watch.elapsed() < trial_s; ++steps) simulation.advance(std::numeric_limits<double>::infinity());
  return watch.elapsed() / static_cast<double>(steps * simulation.state().rod_count());
}

}  // namespace fiberfate
