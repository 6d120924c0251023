// Packs the large cases that docs/theory/packing.md quotes; counters say what was reached. The argument is
// the seed.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "packing/packing.hpp"

namespace fiberfate {
namespace {

struct PackingCase {
  std::string name;
  double length = 0, rod_length = 0;  // m
  ConcentrationRequest amount;
  Vec3 orientation = Vec3::Constant(1.0 / 3);  // principal values
  double radius = 0;                           // wanted, m
};

ConcentrationRequest in_cube(std::int64_t count, double edge) {
  ConcentrationRequest amount;
  amount.count = count;
  amount.cell_size = Vec3::Constant(edge);
  return amount;
}

ConcentrationRequest at_fraction(std::int64_t count, double fraction) {
  ConcentrationRequest amount;
  amount.count = count;
  amount.volume_fraction = fraction;
  return amount;
}

std::vector<PackingCase> cases() {
  const Vec3 isotropic = Vec3::Constant(1.0 / 3), oriented(0.6, 0.3, 0.1);
  const auto by_weight = [](double fraction) { return volume_from_weight_fraction(fraction, 2550, 905); };
  return {
      {"10wt_138_x_0.25mm", 0.25e-3, 0.05e-3, at_fraction(138, by_weight(0.1)), isotropic, 0},
      {"30wt_628_x_2.5mm_isotropic", 2.5e-3, 0.1e-3, in_cube(628, 1.5e-3), isotropic, 1.2e-3},
      {"30wt_628_x_2.5mm_oriented", 2.5e-3, 0.1e-3, in_cube(628, 1.5e-3), oriented, 1.2e-3},
      {"21vol_1000_x_2.5mm_isotropic", 2.5e-3, 0.1e-3, in_cube(1000, 1.5e-3), isotropic, 0},
      {"21vol_1000_x_2.5mm_oriented", 2.5e-3, 0.1e-3, in_cube(1000, 1.5e-3), oriented, 0},
      {"60wt_1000_x_0.25mm", 0.25e-3, 0.025e-3, at_fraction(1000, by_weight(0.6)), isotropic, 0.5e-3},
      {"15vol_100000_x_0.38mm", 0.38e-3, 0, at_fraction(100000, 0.15), isotropic, 0},
  };
}

PackingRequest request_of(const PackingCase& one, std::uint64_t seed) {
  FiberSpecies species;
  species.material = {9.5e-6, 73e9, 2550};
  species.length = SingleLength{one.length};
  species.rod_length = one.rod_length;
  Population population = plan_population({species}, one.amount, seed);
  PackingRequest request;
  request.materials = std::move(population.materials);
  request.fibers = std::move(population.fibers);
  request.cell = rectangular_cell(population.cell_size);
  request.orientation.tensor = one.orientation.asDiagonal();
  request.minimum_radius = one.radius;
  request.seed = seed;
  return request;
}

void pack_case(benchmark::State& state, const PackingCase& one) {
  const PackingRequest request = request_of(one, static_cast<std::uint64_t>(state.range(0)));
  for (auto _ : state) {
    const PackingReport report = pack(request).report;
    state.counters["steps"] = report.steps;
    state.counters["overlap_D"] = report.largest_overlap;
    state.counters["R_min_um"] = 1e6 * report.minimum_radius;
    state.counters["R_mean_um"] = 1e6 / report.mean_curvature;
    state.counters["A2_error"] = report.orientation_error;
    state.counters["contacts"] = report.contacts_per_fiber;
    state.counters["contacts_random"] = report.contacts_random;
  }
}

[[maybe_unused]] const bool registered = [] {
  for (const PackingCase& one : cases()) {
    benchmark::RegisterBenchmark(("pack/" + one.name).c_str(), pack_case, one)
        ->DenseRange(1, 5)
        ->Iterations(1)
        ->Unit(benchmark::kSecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
  }
  return true;
}();

}  // namespace
}  // namespace fiberfate
