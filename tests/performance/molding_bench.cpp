// Times whole fillings: heat, orientation by iARD-RPR, ten length laws, 20 layers, 300 steps.
#include <benchmark/benchmark.h>

#include <cmath>

#include "base/timer.hpp"
#include "continuum/length_registry.hpp"
#include "continuum/orientation_registry.hpp"
#include "molding/filling.hpp"

namespace fiberfate {
namespace {

/// A plate, flat or (for `rise` above 0) bulged like a tailgate, with crossed diagonals.
Shell plate(double length, double width, double thickness, int along, double rise) {
  Shell shell;
  const int across = static_cast<int>(std::lround(along * width / length));
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i <= along; ++i) {
      const double u = static_cast<double>(i) / along, v = static_cast<double>(j) / across;
      shell.nodes.emplace_back(length * u, width * v, rise * u * (1 - u) * v * (1 - v) * 16);
    }
  const auto node = [&](int i, int j) { return static_cast<Index>(j * (along + 1) + i); };
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < along; ++i) {
      const Index a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
      const bool even = (i + j) % 2 == 0;
      shell.triangles.push_back({a, b, even ? c : d});
      shell.triangles.push_back({even ? a : b, c, d});
    }
  shell.thickness.assign(shell.triangles.size(), thickness);
  return shell;
}

FillingParams with_everything() {
  FillingParams params;
  const double melt[] = {25000, 0.3, 4e12, 263.15, 0, 26.5, 51.6};
  params.material = {make_viscosity_law("cross_wlf", melt), 1000, 2300, 0.2, 273.15 + 135};
  params.process.inlet_temperature = 273.15 + 250;
  params.process.mold_temperature = 273.15 + 50;
  params.process.switchover_fraction = 0.995;
  OrientationModel model = orientation_model_named("iard_rpr", "ibof");
  model.constants.c_i = 0.0165;
  model.constants.c_m = 0.999;
  model.constants.alpha = 0.965;
  params.fibers.orientation = model;
  for (int i = 1; i <= 10; ++i) {
    const double values[] = {1, 1e-3 * i, 2e9, 19e-6};
    params.fibers.length_sets.push_back({"xi", make_attrition_law("unbreakable_length", values)});
  }
  params.fibers.class_lengths = {0.012};
  return params;
}

void fill(benchmark::State& state, const Shell& shell, const FillingParams& params) {
  std::array<double, filling_phase_count> seconds{};
  for (auto _ : state) {
    Filling filling{ShellMesh(shell), params};
    filling.run_to_end();
    for (std::size_t p = 0; p < filling_phase_count; ++p)
      seconds[p] += filling.seconds(static_cast<FillingPhase>(p));
    if (filling.state().stop_reason != FillingEnd::filled) state.SkipWithError("the cavity did not fill");
  }
  state.counters["nodes"] = static_cast<double>(shell.nodes.size());
  state.counters["peak_MiB"] = static_cast<double>(peak_memory_bytes()) / (1 << 20);
  for (std::size_t p = 0; p < filling_phase_count; ++p)
    state.counters[filling_phase_names[p]] =
        benchmark::Counter(seconds[p], benchmark::Counter::kAvgIterations);
}

/// Plaque of 305 × 102 × 2 mm in 2 s through a film gate.
void plaque(benchmark::State& state) {
  FillingParams params = with_everything();
  Gate gate;
  gate.end = Vec3(0, 0.102, 0);
  gate.radius = 1e-5;
  params.gates = {gate};
  params.process.flow = FlowProfile::constant(0.305 * 0.102 * 0.002 / 2);
  fill(state, plate(0.305, 0.102, 0.002, static_cast<int>(state.range(0)), 0), params);
}

/// Shell of 4933 cm³ and 3 mm, 616.7 cm³/s, nine gates that open one after the other.
void nine_gate_shell(benchmark::State& state) {
  FillingParams params = with_everything();
  const double length = 1.55, width = 1.06, rise = 0.1;
  for (int g = 0; g < 9; ++g) {
    Gate gate;
    const double u = 0.2 + 0.3 * (g % 3), v = 0.2 + 0.3 * (g / 3);
    gate.position = {length * u, width * v, rise * u * (1 - u) * v * (1 - v) * 16};
    gate.radius = 4e-3;
    if (g != 4) gate.intervals[0].opens = {TriggerKind::filled_fraction, 0.05 + 0.03 * g};
    params.gates.push_back(gate);
  }
  params.process.flow = FlowProfile::constant(616.7e-6);
  fill(state, plate(length, width, 0.003, static_cast<int>(state.range(0)), rise), params);
}

BENCHMARK(plaque)->Arg(78)->Arg(154)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);
BENCHMARK(nine_gate_shell)->Arg(152)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace fiberfate
