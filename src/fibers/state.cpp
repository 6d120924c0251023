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

/// The nodes [begin, end) of a fiber.
struct FiberPart {
  Index fiber, begin, end;
};

void copy_part(const FiberState& whole, FiberPart part, FiberState& parts) {
  const auto f = static_cast<std::size_t>(part.fiber);
  const Index offset = part.begin - whole.begin_node(part.fiber);
  for (Index k = part.begin; k < part.end; ++k) {
    const auto n = static_cast<std::size_t>(k);
    parts.position.push_back(whole.position[n]);
    parts.relative_velocity.push_back(whole.relative_velocity[n]);
    parts.rod_length.push_back(k + 1 == part.end ? 0 : whole.rod_length[n]);
  }
  parts.first_node.push_back(parts.node_count());
  parts.birth_id.push_back(whole.birth_id[f]);
  parts.birth_node.push_back(whole.birth_node[f] + static_cast<std::uint32_t>(offset));
  parts.material_id.push_back(whole.material_id[f]);
  parts.touches_previous.push_back(offset > 0 ? 1 : whole.touches_previous[f]);
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
  state.first_node.push_back(state.node_count());
}

double fiber_length(const FiberState& state, Index fiber) {
  double length = 0;
  for (Index k = state.begin_node(fiber); k + 1 < state.end_node(fiber); ++k)
    length += state.rod_length[static_cast<std::size_t>(k)];
  return length;
}

Vec3 fiber_centroid(const FiberState& state, Index fiber) {
  Vec3 moment = Vec3::Zero();
  double length = 0;
  for (Index k = state.begin_node(fiber); k + 1 < state.end_node(fiber); ++k) {
    const auto i = static_cast<std::size_t>(k);
    moment += state.rod_length[i] * 0.5 * (state.position[i] + state.position[i + 1]);
    length += state.rod_length[i];
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

void split_fibers(FiberState& state, std::span<const Index> nodes) {
  if (nodes.empty()) return;
  FiberState parts;
  auto next = nodes.begin();
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    Index begin = state.begin_node(fiber);
    while (next != nodes.end() && *next < state.end_node(fiber)) {
      copy_part(state, {fiber, begin, *next + 1}, parts);
      begin = *next++;
    }
    copy_part(state, {fiber, begin, state.end_node(fiber)}, parts);
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
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    const IntVec3 image = image_of(state.cell, fiber_centroid(state, fiber));
    if (image.isZero()) continue;
    const Vec3 shift = state.cell.shift(image);
    for (Index k = state.begin_node(fiber); k < state.end_node(fiber); ++k)
      state.position[static_cast<std::size_t>(k)] -= shift;
  }
}

void number_by_height(FiberState& state) {
  const Mat3 to_fraction = state.cell.lattice.inverse();
  std::vector<std::pair<double, Index>> order;
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    const double height = to_fraction.row(1).dot(fiber_centroid(state, fiber));
    order.emplace_back(height - std::floor(height), fiber);
  }
  std::sort(order.begin(), order.end());
  FiberState numbered;
  numbered.materials = state.materials;
  numbered.cell = state.cell;
  for (const auto& [height, fiber] : order) {
    const Vec3* nodes = state.position.data();
    append_fiber(numbered, {{nodes + state.begin_node(fiber), nodes + state.end_node(fiber)},
                            state.material_id[static_cast<std::size_t>(fiber)]});
  }
  state = std::move(numbered);
}

double volume_fraction(const FiberState& state) {
  double volume = 0;
  for (Index fiber = 0; fiber < state.fiber_count(); ++fiber) {
    const double radius = state.material(fiber).radius;
    volume += pi * radius * radius * fiber_length(state, fiber);
  }
  return volume / state.cell.volume();
}

}  // namespace fiberfate
