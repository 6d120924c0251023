// Builds, measures and splits fibers.
#include "fibers/state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/constants.hpp"
#include "base/error.hpp"

namespace fiberfate {
namespace {

// Sine of the turning angle below which three nodes count as being on a line: round-off of coordinates, not
// bending.
constexpr double straightness = 1e-12;

void copy_part(const FiberState& whole, FiberIndex fiber, IndexRange<NodeIndex> nodes, FiberState& parts) {
  const Index offset = nodes.front() - whole.begin_node(fiber);
  for (const NodeIndex node : nodes) {
    parts.position.push_back(whole.position[node]);
    parts.relative_velocity.push_back(whole.relative_velocity[node]);
    parts.rod_length.push_back(whole.rod_length[rod_after(node)]);
  }
  parts.rod_length.back() = 0;
  parts.first_node.push_back(NodeIndex(parts.node_count()));
  parts.birth_id.push_back(whole.birth_id[fiber]);
  parts.birth_node.push_back(whole.birth_node[fiber] + static_cast<std::uint32_t>(offset));
  parts.material_id.push_back(whole.material_id[fiber]);
  parts.touches_previous.push_back(offset > 0 ? 1 : whole.touches_previous[fiber]);
}

}  // namespace

double FiberMaterial::bending_stiffness() const {
  return youngs_modulus * pi * std::pow(radius, 4) / 4;
}

void append_fiber(FiberState& state, const FiberShape& fiber) {
  if (fiber.nodes.size() < 2) throw InputError("a fiber has fewer than two nodes", "give at least two");
  if (fiber.material_id >= state.materials.size())
    throw InputError("a fiber has an unknown material", "name one of the materials that are defined");
  for (std::size_t k = 0; k < fiber.nodes.size(); ++k) {
    if (!fiber.nodes[k].allFinite())
      throw InputError("a node of a fiber is not finite", "give three numbers, in m");
    const bool last = k + 1 == fiber.nodes.size();
    const double length = last ? 0 : (fiber.nodes[k + 1] - fiber.nodes[k]).norm();
    if (!last && !(length > 0))
      throw InputError("a fiber has a rod without length", "remove the doubled node");
    state.position.push_back(fiber.nodes[k]);
    state.relative_velocity.push_back(Vec3::Zero());
    state.rod_length.push_back(length);
  }
  state.birth_id.push_back(static_cast<std::uint32_t>(state.fiber_count()));
  state.birth_node.push_back(0);
  state.material_id.push_back(fiber.material_id);
  state.touches_previous.push_back(0);
  state.first_node.push_back(NodeIndex(state.node_count()));
}

double fiber_length(const FiberState& state, FiberIndex fiber) {
  double length = 0;
  for (const RodIndex rod : state.rods(fiber)) length += state.rod_length[rod];
  return length;
}

Vec3 fiber_centroid(const FiberState& state, FiberIndex fiber) {
  Vec3 moment = Vec3::Zero();
  double length = 0;
  for (const RodIndex rod : state.rods(fiber)) {
    moment += state.rod_length[rod] * state.centre(rod);
    length += state.rod_length[rod];
  }
  return moment / length;
}

double hinge_radius(const Vec3& before, const Vec3& at, const Vec3& after) {
  const Vec3 a = at - before;
  const Vec3 b = after - at;
  const double cross = a.cross(b).norm();
  const double product = a.norm() * b.norm();
  if (cross <= straightness * product) {
    return a.dot(b) > 0 ? std::numeric_limits<double>::infinity() : 0.0;
  }
  return product * (after - before).norm() / (2 * cross);
}

void split_fibers(FiberState& state, std::span<const NodeIndex> nodes) {
  if (nodes.empty()) return;
  FiberState parts;
  auto next = nodes.begin();
  for (const FiberIndex fiber : state.fibers()) {
    NodeIndex begin = state.begin_node(fiber);
    while (next != nodes.end() && *next < state.end_node(fiber)) {
      copy_part(state, fiber, {begin, *next + 1}, parts);
      begin = *next++;
    }
    copy_part(state, fiber, {begin, state.end_node(fiber)}, parts);
  }
  state.position.swap(parts.position);
  state.relative_velocity.swap(parts.relative_velocity);
  state.rod_length.swap(parts.rod_length);
  state.first_node.swap(parts.first_node);
  state.birth_id.swap(parts.birth_id);
  state.birth_node.swap(parts.birth_node);
  state.material_id.swap(parts.material_id);
  state.touches_previous.swap(parts.touches_previous);
  state.breaks += static_cast<std::int64_t>(nodes.size());
}

void wrap_fibers(FiberState& state) {
  for (const FiberIndex fiber : state.fibers()) {
    const IntVec3 image = image_of(state.cell, fiber_centroid(state, fiber));
    if (image.isZero()) continue;
    const Vec3 shift = state.cell.shift(image);
    for (const NodeIndex node : state.nodes(fiber)) state.position[node] -= shift;
  }
}

void number_by_height(FiberState& state) {
  const Mat3 to_fraction = state.cell.lattice.inverse();
  std::vector<std::pair<double, FiberIndex>> order;
  for (const FiberIndex fiber : state.fibers()) {
    const double height = to_fraction.row(1).dot(fiber_centroid(state, fiber));
    order.emplace_back(height - std::floor(height), fiber);
  }
  std::sort(order.begin(), order.end());
  FiberState numbered;
  numbered.materials = state.materials;
  numbered.cell = state.cell;
  for (const auto& [height, fiber] : order)
    append_fiber(numbered, {state.positions(fiber), state.material_id[fiber]});
  state = std::move(numbered);
}

double volume_fraction(const FiberState& state) {
  double volume = 0;
  for (const FiberIndex fiber : state.fibers()) {
    const double radius = state.material(fiber).radius;
    volume += pi * radius * radius * fiber_length(state, fiber);
  }
  return volume / state.cell.volume();
}

}  // namespace fiberfate
