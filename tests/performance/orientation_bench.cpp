// Times orientation laws on one core: right-hand sides a second, single points, closures.
#include <benchmark/benchmark.h>

#include <vector>

#include "continuum/orientation_history.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

/// As many points as one thread takes at a time, so that no other thread starts.
constexpr std::size_t count = 256;

struct Points {
  std::vector<double> second, gradient, result;
  OrientationPoints view;
  Points() : second(6 * count), gradient(9 * count), result(6 * count) {
    for (std::size_t i = 0; i < count; ++i) {
      const double x = static_cast<double>(i) / count;
      const double state[6] = {0.6 + 0.2 * x, 0.25 - 0.1 * x, 0.15 - 0.1 * x, 0.02, 0.03, 0.05};
      const double flow[9] = {0.1, 2 + x, 0.3, -0.2, -0.05, 0.4, 0.5, 0.6, -0.05};
      for (std::size_t m = 0; m < 6; ++m) second[m * count + i] = state[m];
      for (std::size_t m = 0; m < 9; ++m) gradient[m * count + i] = flow[m];
    }
    view.count = count;
    for (std::size_t m = 0; m < 6; ++m) view.second[m] = &second[m * count];
    for (std::size_t m = 0; m < 6; ++m) view.result[m] = &result[m * count];
    for (std::size_t m = 0; m < 9; ++m) view.gradient[m] = &gradient[m * count];
  }
};

OrientationLaw law_of(const char* name, const char* closure) {
  OrientationModel model = orientation_model_named(name, closure);
  if (model.diffusion != RotaryDiffusion::none) model.constants.c_i = 0.0165;
  if (model.diffusion == RotaryDiffusion::iard) model.constants.c_m = 0.999;
  if (model.retardation == Retardation::rpr) model.constants.alpha = 0.965;
  return OrientationLaw(model);
}

void rates(benchmark::State& state, const char* name, const char* closure) {
  const OrientationLaw law = law_of(name, closure);
  const Points points;
  for (auto _ : state) {
    law.evaluate(points.view);
    benchmark::DoNotOptimize(points.result.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * count));
}

void one_rate(benchmark::State& state) {
  const OrientationLaw law = law_of("iard_rpr", "ibof");
  const Mat3 second = Vec3(0.6, 0.3, 0.1).asDiagonal();
  for (auto _ : state) benchmark::DoNotOptimize(law.rate(second, simple_shear_gradient()));
}

BENCHMARK_CAPTURE(rates, iard_rpr_ibof, "iard_rpr", "ibof");
BENCHMARK_CAPTURE(rates, iard_rpr_ore, "iard_rpr", "ore");
BENCHMARK_CAPTURE(rates, folgar_tucker_ibof, "folgar_tucker", "ibof");
BENCHMARK_CAPTURE(rates, folgar_tucker_hybrid, "folgar_tucker", "hybrid");
BENCHMARK_CAPTURE(rates, folgar_tucker_exact, "folgar_tucker", "exact");
BENCHMARK(one_rate);

}  // namespace
}  // namespace fiberfate
