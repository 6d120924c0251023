// Packs the large cases that docs/theory/packing.md quotes, checks them and prints one line each; not part of
// CI.
//
// packing_bench [case] [seed]: case is a part of a name below; all are run without it.
#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "base/timer.hpp"
#include "packing/packing.hpp"

namespace fiberfate {
namespace {

struct BenchmarkCase {
  std::string name;
  double length, rod_length;  // m
  ConcentrationRequest amount;
  Vec3 orientation;   // principal values
  double radius = 0;  // wanted, m
};

std::vector<BenchmarkCase> cases() {
  const Vec3 isotropic = Vec3::Constant(1.0 / 3), oriented(0.6, 0.3, 0.1);
  const auto count_in_cube = [](std::int64_t count, double edge) {
    ConcentrationRequest amount;
    amount.count = count;
    amount.cell_size = Vec3::Constant(edge);
    return amount;
  };
  const auto count_at = [](std::int64_t count, double fraction) {
    ConcentrationRequest amount;
    amount.count = count;
    amount.volume_fraction = fraction;
    return amount;
  };
  const double glass = 2550, polypropylene = 905;
  return {
      {"10wt_138", 0.25e-3, 0.05e-3, count_at(138, volume_from_weight_fraction(0.1, glass, polypropylene)),
       isotropic, 0},
      {"30wt_628_isotropic", 2.5e-3, 0.1e-3, count_in_cube(628, 1.5e-3), isotropic, 1.2e-3},
      {"30wt_628_oriented", 2.5e-3, 0.1e-3, count_in_cube(628, 1.5e-3), oriented, 1.2e-3},
      {"21vol_1000_isotropic", 2.5e-3, 0.1e-3, count_in_cube(1000, 1.5e-3), isotropic, 0},
      {"21vol_1000_oriented", 2.5e-3, 0.1e-3, count_in_cube(1000, 1.5e-3), oriented, 0},
      {"60wt_short", 0.25e-3, 0.025e-3,
       count_at(1000, volume_from_weight_fraction(0.6, glass, polypropylene)), isotropic, 0.5e-3},
      {"15vol_short_100000", 0.38e-3, 0, count_at(100000, 0.15), isotropic, 0},
  };
}

void run(const BenchmarkCase& one, std::uint64_t seed) {
  FiberSpecies species;
  species.material = {9.5e-6, 73e9, 2550};
  species.length = SingleLength{one.length};
  species.rod_length = one.rod_length;
  const Population population = plan_population({species}, one.amount, seed);
  PackingRequest request;
  request.materials = population.materials;
  request.fibers = population.fibers;
  request.cell = rectangular_cell(population.cell_size);
  request.orientation.tensor = one.orientation.asDiagonal();
  request.minimum_radius = one.radius;
  request.seed = seed;
  const double cpu = cpu_seconds(), wall = wall_seconds();
  try {
    const PackingReport report = pack(request).report;
    fmt::print(
        "{:22} seed {}: {:6.2f} s wall {:6.2f} s cpu {:5} steps, phi {:.4f}, overlap {:.4f} D, R_min {:6.1f} "
        "um, 1/mean {:6.1f} um, "
        "A2 error {:.1e}, contacts {:.1f} (random {:.1f})\n",
        one.name, seed, wall_seconds() - wall, cpu_seconds() - cpu, report.steps, report.volume_fraction,
        report.largest_overlap, 1e6 * report.minimum_radius, 1e6 / report.mean_curvature,
        report.orientation_error, report.contacts_per_fiber, report.contacts_random);
    if (std::getenv("PAIRS") != nullptr)
      for (const PairDistanceBin& bin : report.pair_distances)
        fmt::print("  {:.1f} {:.3f} {:.3f}\n", bin.low, bin.per_fiber, bin.random);
  } catch (const std::exception& failure) {
    fmt::print("{:22} seed {}: {:6.2f} s wall {:6.2f} s cpu: {}\n", one.name, seed, wall_seconds() - wall,
               cpu_seconds() - cpu, failure.what());
  }
}

}  // namespace
}  // namespace fiberfate

int main(int count, char** arguments) {
  const std::string wanted = count > 1 ? arguments[1] : "";
  const std::uint64_t seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  for (const auto& one : fiberfate::cases()) {
    if (one.name.find(wanted) != std::string::npos) fiberfate::run(one, seed);
  }
  return 0;
}
