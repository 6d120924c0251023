// Builds the small populations that the particle tests run, and runs them.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "base/constants.hpp"
#include "base/random.hpp"
#include "dynamics/simulation.hpp"
#include "fibers/closest_points.hpp"
#include "fibers/state.hpp"

namespace fiberfate::scenes {

/// The glass fiber of the thesis: 19 µm, 73 GPa.
inline const FiberMaterial glass{.radius = 9.5e-6, .youngs_modulus = 73e9, .density = 2550};
/// Two of them that touch.
inline const ContactPair glass_pair{contact_body(glass), contact_body(glass)};
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

/// Describes straight fibers scattered in a periodic cube without overlap.
struct Scatter {
  int fibers = 0;
  double length = 0;  ///< m
  int rods = 1;       ///< a fiber
  double cell = 0;    ///< edge, m
  std::uint64_t seed = 1;
  FiberMaterial material = glass;
};

/// Tells whether a straight fiber comes nearer than `clearance` to one in the state or to its own image.
inline bool touches(const FiberState& state, const Segment& fiber, double clearance) {
  for (Index number = 0; number <= state.fiber_count(); ++number) {
    const bool itself = number == state.fiber_count();
    const FiberIndex other(number);
    const Segment target =
        itself ? fiber
               : Segment{state.position[state.begin_node(other)], state.position[state.last_node(other)]};
    const double edge = state.cell.lattice(0, 0);
    const int images = int(std::ceil((fiber.end - fiber.begin).norm() / edge)) + 1;
    for (int i = -images; i <= images; ++i) {
      for (int j = -images; j <= images; ++j) {
        for (int k = -images; k <= images; ++k) {
          if (itself && i == 0 && j == 0 && k == 0) continue;
          const Vec3 shift = edge * Vec3(i, j, k);
          if (closest_points(fiber, {target.begin + shift, target.end + shift}).distance < clearance)
            return true;
        }
      }
    }
  }
  return false;
}

/// Sixty fibers at 4.7 % by volume, seventy times softer than glass: fast shear folds and breaks them within
/// milliseconds.
inline Scatter soft_fibers() {
  return {.fibers = 60,
          .length = 0.6e-3,
          .rods = 12,
          .cell = 0.6e-3,
          .seed = 11,
          .material = {.radius = 9.5e-6, .youngs_modulus = 1e9, .density = 2550}};
}

/// Places fibers of uniformly random position and direction one by one where they touch no other.
inline FiberState scatter(const Scatter& wanted) {
  FiberState state = empty_cell(wanted.cell, wanted.material);
  for (std::uint32_t attempt = 0; state.fiber_count() < Index(wanted.fibers); ++attempt) {
    const auto u = uniform4(wanted.seed, RandomStream::position, {attempt, 0, 0});
    const auto v = uniform4(wanted.seed, RandomStream::orientation, {attempt, 0, 0});
    const double z = 2 * v[0] - 1;
    const double angle = 2 * pi * v[1];
    const double across = std::sqrt(1 - z * z);
    const StraightFiber fiber{.centre = wanted.cell * Vec3(u[0], u[1], u[2]),
                              .direction = Vec3(across * std::cos(angle), across * std::sin(angle), z),
                              .length = wanted.length,
                              .rods = wanted.rods};
    const auto nodes = nodes_of(fiber);
    if (!touches(state, {nodes.front(), nodes.back()}, 2.2 * glass.radius))
      append_fiber(state, {.nodes = nodes, .material_id = 0});
  }
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

inline Vec3 end_to_end(const FiberState& state, FiberIndex fiber = {}) {
  return state.position[state.last_node(fiber)] - state.position[state.begin_node(fiber)];
}

}  // namespace fiberfate::scenes
