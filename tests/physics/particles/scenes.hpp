// Builds the small populations that the particle tests run, and runs them.
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/simulation.hpp"
#include "fibers/state.hpp"

namespace fiberfate::scenes {

/// The glass fiber of the thesis: 19 µm, 73 GPa.
inline const FiberMaterial glass{.radius = 9.5e-6, .youngs_modulus = 73e9, .density = 2550};
/// The melt of the thesis' Couette experiment.
inline constexpr double melt_viscosity = 200;  // Pa s
inline constexpr double couette_rate = 16.65;  // 1/s

/// Describes a straight fiber.
struct StraightFiber {
  Vec3 centre = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();
  double length = 0;  ///< m
  int rods = 1;       ///< of equal length
};

inline std::vector<Vec3> nodes_of(const StraightFiber& fiber) {
  std::vector<Vec3> nodes;
  const Vec3 p = fiber.direction.normalized();
  for (int k = 0; k <= fiber.rods; ++k)
    nodes.emplace_back(fiber.centre + (double(k) / fiber.rods - 0.5) * fiber.length * p);
  return nodes;
}

/// A cubic cell without fibers.
inline FiberState empty_cell(double size, const FiberMaterial& material = glass) {
  FiberState state;
  state.cell = rectangular_cell(Vec3::Constant(size));
  state.materials = {material};
  return state;
}

/// One fiber in a cell in which it cannot meet itself.
inline FiberState lone_fiber(const std::vector<Vec3>& nodes, const FiberMaterial& material = glass) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) length += (nodes[k + 1] - nodes[k]).norm();
  FiberState state = empty_cell(4 * length, material);
  append_fiber(state, {.nodes = nodes, .material_id = 0});
  return state;
}

/// Everything at its default except: no breakage, and steps of one size.
inline DynamicsParameters fixed_step(double step) {
  DynamicsParameters parameters;
  parameters.step.control = StepControl::fixed;
  parameters.step.initial = step;
  parameters.step.maximum = step;
  return parameters;
}

/// The same without contact.
inline DynamicsParameters lone_and_fixed_step(double step) {
  DynamicsParameters parameters = fixed_step(step);
  parameters.contact.force_constant = 0;
  return parameters;
}

inline void run_until(Simulation& simulation, double time) {
  while (simulation.state().time < time) simulation.advance(time);
}

inline Vec3 end_to_end(const FiberState& state, Index fiber = 0) {
  return state.position[std::size_t(state.end_node(fiber)) - 1] -
         state.position[std::size_t(state.begin_node(fiber))];
}

}  // namespace fiberfate::scenes
