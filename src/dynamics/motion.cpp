// Moves nodes with the fluid and relative to it.
#include "dynamics/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/matrix_product.hpp"
#include "base/threads.hpp"
#include "fibers/closest_points.hpp"

namespace fiberfate {
namespace {

// Strayed fibers are looked for every so many steps; one cell's width of straying is harmless.
constexpr std::int64_t steps_between_wraps = 64;

/// Gives every rod its length back, along its present direction, about the fiber's centroid.
void restore_lengths(FiberState& state, FiberIndex fiber) {
  Vec3 moved = state.position[state.begin_node(fiber)];
  Vec3 drift = Vec3::Zero();  // of a node from where it was
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (const RodIndex rod : state.rods(fiber)) {
    Vec3& end = state.position[second_end(rod)];
    const Vec3 axis = end - moved;
    const double stretch = state.rod_length[rod] / axis.norm() - 1;
    moved = end;
    const Vec3 before = drift;
    drift += stretch * axis;
    end += drift;
    sum += 0.5 * state.rod_length[rod] * (before + drift);
    length += state.rod_length[rod];
  }
  const Vec3 shift = -sum / length;
  for (const NodeIndex node : state.nodes(fiber)) state.position[node] += shift;
}

bool has_strayed(const FiberState& state) {
  for (const FiberIndex fiber : state.fibers()) {
    const NodeIndex middle = state.begin_node(fiber) + state.nodes(fiber).size() / 2;
    if (image_of(state.cell, state.position[middle]).cwiseAbs().maxCoeff() > 1) return true;
  }
  return false;
}

}  // namespace

void extrapolate_to_middle(const FiberState& state, const Flow& flow, double step,
                           IndexedSpan<NodeIndex, Vec3> middle) {
  const double half = 0.5 * step;
  parallel_for(state.nodes(), [&](NodeIndex node) {
    const Vec3& x = state.position[node];
    middle[node] = x + half * (flow.gradient * x + state.relative_velocity[node]);
  });
}

void move_fibers(FiberState& state, const Flow& flow, double step,
                 IndexedSpan<NodeIndex, const Vec3> relative_velocity,
                 IndexedSpan<RodIndex, double> travelled) {
  const Mat3 affine = flow_map(flow.gradient, step);
  parallel_for_weighted(state.first_node, [&](FiberIndex fiber) {
    for (const NodeIndex node : state.nodes(fiber)) {
      const Vec3 turned = product(flow.gradient, state.relative_velocity[node]);
      const Vec3 displacement = step * (relative_velocity[node] + 0.5 * step * turned);
      state.position[node] = product(affine, state.position[node]) + displacement;
      state.relative_velocity[node] = relative_velocity[node];
      const double distance = displacement.norm();
      travelled[rod_after(node)] = distance;
      if (node == state.begin_node(fiber)) continue;
      double& before = travelled[rod_before(node)];
      before = std::max(before, distance);
    }
    restore_lengths(state, fiber);
  });
  deform(state.cell, flow.gradient, step);
  state.time += step;
  ++state.step;
  state.rod_steps += state.rod_count();
}

double displacement_error(const FiberState& state, double step, IndexedVector<FiberIndex, double>& by_fiber,
                          IndexedSpan<NodeIndex, const Vec3> relative_velocity) {
  by_fiber.resize(state.fiber_count());
  parallel_for_weighted(state.first_node, [&](FiberIndex fiber) {
    double sum = 0;
    for (const NodeIndex node : state.nodes(fiber))
      sum += (relative_velocity[node] - state.relative_velocity[node]).squaredNorm();
    const double radius = state.material(fiber).radius;
    by_fiber[fiber] = sum / (radius * radius);
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
  for (FiberIndex fiber(1); fiber < FiberIndex(state.fiber_count()); ++fiber) {
    std::uint8_t& touches = state.touches_previous[fiber];
    if (touches == 0) continue;
    const RodIndex first = rod_after(state.begin_node(fiber));
    // The last rod of the fiber before, whose last node owns none. Once the ends lie in different images they
    // have parted, too.
    if (closest_points(state.segment(first - 2), state.segment(first)).distance > range) touches = 0;
  }
}

}  // namespace fiberfate
