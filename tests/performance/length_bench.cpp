// Measures the length laws in the form in which a mold-filling solver calls them: many points, short steps.
#include <benchmark/benchmark.h>

#include <vector>

#include "base/threads.hpp"
#include "continuum/durin_breakage.hpp"
#include "continuum/phelps_solver.hpp"
#include "continuum/stress_induced.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t points = 4096;

struct Points {
  std::vector<double> rates, viscosities;
  Points() : rates(points), viscosities(points) {
    for (std::size_t i = 0; i < points; ++i) {
      rates[i] = 100 + 1900.0 * static_cast<double>(i) / points;
      viscosities[i] = 2000.0 / (1 + 0.01 * rates[i]);
    }
  }
};

/// Steps of `events` breakages of the longest fiber in the fastest point; 100 bins of fibers up to 15 mm.
void advance_phelps(benchmark::State& state, BreakageShare share) {
  use_threads(1);
  const Points at;
  const PhelpsSolver solver({0.02, 3, 0.25, 73e9, 19e-6, 0, share}, {100, 15e-3});
  const double events = 1e-3 * static_cast<double>(state.range(0));
  const double duration = events / (0.02 * 2000);
  std::vector<double> numbers(100 * points, 1.0);
  for (auto _ : state) {
    solver.advance({at.rates, at.viscosities}, duration, numbers);
    benchmark::DoNotOptimize(numbers.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}
BENCHMARK_CAPTURE(advance_phelps, phelps, PhelpsBreakage::share)
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(advance_phelps, durin, DurinBreakage::share)
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);

void relax_stress_induced(benchmark::State& state) {
  use_threads(1);
  const Points at;
  const RelaxationLawOf law(StressInduced{2.04e-6, 1.353, 67821, 1.139, 2e9, 19e-6});
  const auto classes = static_cast<std::size_t>(state.range(0));
  std::vector<double> lengths(classes * points, 15e-3);
  for (auto _ : state) {
    relax_lengths(law, {at.rates, at.viscosities}, 1e-3, lengths);
    benchmark::DoNotOptimize(lengths.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
}
BENCHMARK(relax_stress_induced)->Arg(1)->Arg(30)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace fiberfate
