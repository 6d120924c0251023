// Times orientation laws on one core: right-hand sides a second, single points, closures.
#include <benchmark/benchmark.h>

#include <vector>

#include "base/threads.hpp"
#include "continuum/orientation_history.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

/// Points that stay in the cache of one core, and as many as a mold has, which come from memory.
constexpr std::size_t few = 256, many = 1 << 17;

struct Points {
  std::vector<double> second, gradient, result;
  OrientationPoints view;
  explicit Points(std::size_t count) : second(6 * count), gradient(9 * count), result(6 * count) {
    for (std::size_t i = 0; i < count; ++i) {
      const double x = static_cast<double>(i) / static_cast<double>(count);
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
  if (model.diffusion != rotary_diffusion_named("jeffery")) model.constants.c_i = 0.0165;
  if (model.diffusion == rotary_diffusion_named("iard")) model.constants.c_m = 0.999;
  if (model.retardation == retardation_named("rpr")) model.constants.alpha = 0.965;
  return OrientationLaw(model);
}

void rates(benchmark::State& state, const char* name, const char* closure) {
  use_threads(1);
  const OrientationLaw law = law_of(name, closure);
  const auto count = static_cast<std::size_t>(state.range(0));
  const Points points(count);
  for (auto _ : state) {
    law.evaluate(points.view);
    benchmark::DoNotOptimize(points.result.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// Integrates over a time step of a tenth of a unit of strain, as a mold-filling solver does.
void advance(benchmark::State& state, const char* name, const char* closure) {
  use_threads(1);
  const OrientationLaw law = law_of(name, closure);
  const Points points(few);
  for (auto _ : state) {
    law.advance(points.view, {.duration = 0.05, .tolerance = 1e-5});
    benchmark::DoNotOptimize(points.result.data());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * few));
}

void one_rate(benchmark::State& state) {
  const OrientationLaw law = law_of("iard_rpr", "ibof");
  const Mat3 second = Vec3(0.6, 0.3, 0.1).asDiagonal();
  for (auto _ : state) benchmark::DoNotOptimize(law.rate(second, simple_shear_gradient()));
}

BENCHMARK_CAPTURE(rates, iard_rpr_ibof, "iard_rpr", "ibof")->Arg(few)->Arg(many);
BENCHMARK_CAPTURE(rates, iard_rpr_ore, "iard_rpr", "ore")->Arg(few)->Arg(many);
BENCHMARK_CAPTURE(rates, folgar_tucker_ibof, "folgar_tucker", "ibof")->Arg(few);
BENCHMARK_CAPTURE(rates, folgar_tucker_hybrid, "folgar_tucker", "hybrid")->Arg(few);
BENCHMARK_CAPTURE(rates, folgar_tucker_exact, "folgar_tucker", "exact")->Arg(few);
BENCHMARK_CAPTURE(advance, iard_rpr_ibof, "iard_rpr", "ibof");
BENCHMARK_CAPTURE(advance, iard_rpr_ore, "iard_rpr", "ore");
BENCHMARK(one_rate);

}  // namespace
}  // namespace fiberfate
