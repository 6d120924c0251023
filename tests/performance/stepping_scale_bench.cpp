// Steps cells of ten thousand to ten million rods: what a rod-step costs, and how much memory a rod takes.
// The argument is the number of fibers, of 25 rods each, at the density of the Couette case.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <utility>

#include "dynamics/simulation.hpp"
#include "packing/packing.hpp"

namespace fiberfate {
namespace {

constexpr int fibers_a_tile = 400;

DynamicsParameters parameters() {
  DynamicsParameters chosen;
  chosen.step.control = StepControl::fixed;
  chosen.step.initial = 1e-4;
  return chosen;
}

FlowHistory couette() {
  return FlowHistory::constant(16.65, 200);
}

/// A packing of 400 fibers of 2.5 mm at 21 % by volume, after 50 ms of shear.
const FiberState& tile() {
  static const FiberState state = [] {
    FiberSpecies species;
    species.material = {9.5e-6, 73e9, 2550};
    species.length = SingleLength{2.5e-3};
    species.rod_length = 0.1e-3;
    ConcentrationRequest amount;
    amount.count = fibers_a_tile;
    amount.volume_fraction = 0.21;
    Population population = plan_population({species}, amount, 1);
    PackingRequest request;
    request.materials = std::move(population.materials);
    request.fibers = std::move(population.fibers);
    request.cell = rectangular_cell(population.cell_size);
    request.seed = 1;
    Simulation simulation(parameters(), couette(), pack(request).state);
    while (simulation.state().time < 0.05) simulation.advance(0.05);
    return simulation.state();
  }();
  return state;
}

/// Repeats the tile nx × ny × nz times, one after the other.
FiberState tiled(const IntVec3& repeats) {
  const FiberState& one = tile();
  FiberState state;
  state.materials = one.materials;
  state.cell = one.cell;
  state.cell.lattice = one.cell.lattice * repeats.cast<double>().asDiagonal();
  for (int x = 0; x < repeats.x(); ++x) {
    for (int y = 0; y < repeats.y(); ++y) {
      for (int z = 0; z < repeats.z(); ++z) {
        FiberState copy = one;
        for (Vec3& node : copy.position) node += one.cell.lattice * Vec3(x, y, z);
        for (const FiberIndex f : copy.fibers()) append_fiber(state, {copy.positions(f), 0});
        std::copy(one.relative_velocity.begin(), one.relative_velocity.end(),
                  state.relative_velocity.end() - one.node_count());
      }
    }
  }
  return state;
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void step(benchmark::State& bench) {
  const auto fibers = static_cast<int>(bench.range(0));
  IntVec3 repeats(1, 1, 1);
  while (repeats.prod() * fibers_a_tile < fibers) {
    int shortest = 0;
    repeats.minCoeff(&shortest);
    const int missing = fibers / (repeats.prod() * fibers_a_tile);
    repeats[shortest] *= missing % 2 == 0 ? 2 : 5;
  }
  const double before = peak_memory();
  Simulation simulation(parameters(), couette(), tiled(repeats));
  for (int i = 0; i < 5; ++i) simulation.advance(1);
  for (auto _ : bench) simulation.advance(1);
  const Index rods = simulation.state().rod_count();
  bench.counters["bytes_a_rod"] = (peak_memory() - before) / rods;
  bench.counters["rods"] = rods;
  bench.SetItemsProcessed(bench.iterations() * rods);
}

// As many steps as a few neighbour lists live, whatever that takes.
BENCHMARK(step)
    ->Arg(400)
    ->Iterations(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(step)
    ->Arg(4000)
    ->Iterations(300)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(step)
    ->Arg(40000)
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(step)
    ->Arg(400000)
    ->Iterations(40)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace fiberfate
