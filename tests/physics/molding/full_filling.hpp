// A plaque whose filling has everything on.
#pragma once

#include "continuum/length_registry.hpp"
#include "continuum/orientation_registry.hpp"
#include "test_shells.hpp"

namespace fiberfate::test {

/// A plaque with everything on: heat, orientation, lengths, coupling, a valve gate, switchover.
inline FillingParams full_params() {
  FillingParams params =
      isothermal(2e-5, viscosity("cross_wlf", {25000, 0.3, 4e12, 263.15, 0, 26.5, 51.6}), {});
  params.material = {params.material.viscosity, 1000, 2300, 0.2, 273.15 + 135};
  params.process.inlet_temperature = 273.15 + 250;
  params.process.mold_temperature = 273.15 + 50;
  params.process.switchover_fraction = 0.98;
  params.numerics.heat = HeatModel::full;
  params.numerics.layers = 8;
  params.numerics.steps = 60;
  Gate second;
  second.position = Vec3(0.08, 0.02, 0);
  second.intervals[0].opens = {TriggerKind::arrival, 0.01};
  params.gates = {{}, second};
  params.gates[0].position = Vec3(0.02, 0.02, 0);
  OrientationModel model = orientation_model_named("iard_rpr", "ibof");
  model.constants.c_i = 0.0165;
  model.constants.c_m = 0.999;
  model.constants.alpha = 0.965;
  params.fibers.orientation = model;
  const double values[] = {0.05, 0.01, 2e9, 19e-6};
  params.fibers.length_sets = {{"xi", make_attrition_law("unbreakable_length", values)}};
  params.fibers.class_lengths = {0.0006};
  params.fibers.coupling = FiberCoupling{0.15, 19e-6, 0, 0, 0};
  return params;
}

inline Shell plaque() {
  return rectangle({0.1, 0.04, 0.002, 25, 10});
}

}  // namespace fiberfate::test
