// Moves nodes with the fluid and relative to it.
#include "dynamics/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/threads.hpp"
#include "fibers/closest_points.hpp"

namespace fiberfate {
namespace {

// Strayed fibers are looked for every so many steps; one cell's width of straying is harmless.
constexpr std::int64_t steps_between_wraps = 64;

Mat3 flow_map(const Flow& flow, double step) {
  Cell fluid;
  deform(fluid, flow.gradient, step);
  return fluid.lattice;
}

/// Gives every rod its length back, along its present direction, about the fiber's centroid.
void restore_lengths(FiberState& state, Index fiber) {
  const auto begin = static_cast<std::size_t>(state.begin_node(fiber));
  const auto end = static_cast<std::size_t>(state.end_node(fiber));
  Vec3 moved = state.position[begin];
  Vec3 drift = Vec3::Zero();  // of a node from where it was
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (std::size_t n = begin; n + 1 < end; ++n) {
    const Vec3 axis = state.position[n + 1] - moved;
    const double stretch = state.rod_length[n] / axis.norm() - 1;
    moved = state.position[n + 1];
    const Vec3 before = drift;
    drift += stretch * axis;
    state.position[n + 1] += drift;
    sum += 0.5 * state.rod_length[n] * (before + drift);
    length += state.rod_length[n];
  }
  const Vec3 shift = -sum / length;
  for (std::size_t n = begin; n < end; ++n) state.position[n] += shift;
}

bool has_strayed(const FiberState& state) {
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    const auto middle = static_cast<std::size_t>((state.begin_node(fiber) + state.end_node(fiber)) / 2);
    if (image_of(state.cell, state.position[middle]).cwiseAbs().maxCoeff() > 1) return true;
  }
  return false;
}

}  // namespace

void extrapolate_to_middle(const FiberState& state, const Flow& flow, double step, std::span<Vec3> middle) {
  const double half = 0.5 * step;
  parallel_for(state.node_count(), [&](std::ptrdiff_t k) {
    const auto n = static_cast<std::size_t>(k);
    const Vec3& x = state.position[n];
    middle[n] = x + half * (flow.gradient * x + state.relative_velocity[n]);
  });
}

void move_fibers(FiberState& state, const Flow& flow, double step, std::span<const Vec3> relative_velocity,
                 std::span<double> travelled) {
  const Mat3 affine = flow_map(flow, step);
  parallel_for_weighted(state.first_node, [&](std::ptrdiff_t f) {
    const Index fiber = static_cast<Index>(f);
    const auto begin = static_cast<std::size_t>(state.begin_node(fiber));
    const auto end = static_cast<std::size_t>(state.end_node(fiber));
    for (std::size_t n = begin; n < end; ++n) {
      const Vec3 displacement =
          step * (relative_velocity[n] + 0.5 * step * (flow.gradient * state.relative_velocity[n]));
      state.position[n] = affine * state.position[n] + displacement;
      state.relative_velocity[n] = relative_velocity[n];
      travelled[n] = displacement.norm();
      if (n > begin) travelled[n - 1] = std::max(travelled[n - 1], travelled[n]);
    }
    restore_lengths(state, fiber);
  });
  deform(state.cell, flow.gradient, step);
  state.time += step;
  ++state.step;
  state.rod_steps += state.rod_count();
}

double displacement_error(const FiberState& state, double step, std::vector<double>& by_fiber,
                          std::span<const Vec3> relative_velocity) {
  by_fiber.resize(static_cast<std::size_t>(state.fiber_count()));
  parallel_for_weighted(state.first_node, [&](std::ptrdiff_t f) {
    const Index fiber = static_cast<Index>(f);
    double sum = 0;
    for (auto n = static_cast<std::size_t>(state.begin_node(fiber));
         n < static_cast<std::size_t>(state.end_node(fiber)); ++n)
      sum += (relative_velocity[n] - state.relative_velocity[n]).squaredNorm();
    const double radius = state.material(fiber).radius;
    by_fiber[static_cast<std::size_t>(f)] = sum / (radius * radius);
  });
  double sum = 0;
  for (const double fiber : by_fiber) sum += fiber;
  const double error = 0.5 * step * std::sqrt(sum / state.node_count());
  return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

bool tidy_cell(FiberState& state) {
  const bool skewed = is_skewed(state.cell);
  if (!skewed && (state.step % steps_between_wraps != 0 || !has_strayed(state))) return false;
  if (skewed) reduce(state.cell);
  wrap_fibers(state);
  return true;
}

void release_separated_ends(FiberState& state, double range) {
  for (Index fiber = 1; fiber < state.fiber_count(); ++fiber) {
    auto& touches = state.touches_previous[static_cast<std::size_t>(fiber)];
    if (touches == 0) continue;
    const auto n = static_cast<std::size_t>(state.begin_node(fiber));
    const Segment before{state.position[n - 2], state.position[n - 1]};
    const Segment after{state.position[n], state.position[n + 1]};
    // Once the ends lie in different images they have parted, too.
    if (closest_points(before, after).distance > range) touches = 0;
  }
}

}  // namespace fiberfate
