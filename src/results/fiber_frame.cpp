// Turns fibers into polylines with their numbers and back.
#include "results/fiber_frame.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace fiberfate {
namespace {

/// Curvature at every node, 1/m: the inverse radius at hinges, zero at ends.
std::vector<float> curvatures(const FiberState& state) {
  IndexedVector<NodeIndex, float> curvature(state.position.size(), 0.0F);
  for (const FiberIndex fiber : state.fibers()) {
    for (const NodeIndex hinge : state.hinges(fiber))
      curvature[hinge] = static_cast<float>(1 / hinge_radius(state, hinge));
  }
  return curvature;
}

std::vector<float> velocities(const FiberState& state) {
  std::vector<float> numbers;
  numbers.reserve(3 * state.relative_velocity.size());
  for (const Vec3& velocity : state.relative_velocity) {
    for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<float>(velocity[axis]));
  }
  return numbers;
}

/// The lattice row by row; its columns are the lattice vectors.
std::vector<double> lattice_rows(const Cell& cell) {
  std::vector<double> numbers;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) numbers.push_back(cell.lattice(row, column));
  }
  return numbers;
}

std::uint16_t material_of_radius(FiberState& state, double radius) {
  const auto same = [radius](const FiberMaterial& material) { return material.radius == radius; };
  const auto found = std::find_if(state.materials.begin(), state.materials.end(), same);
  const auto id = static_cast<std::uint16_t>(found - state.materials.begin());
  if (found == state.materials.end()) state.materials.push_back({radius, 0, 0});
  return id;
}

void append_polyline(FiberState& state, const PolyFrame& frame, std::size_t line, double radius) {
  std::vector<Vec3> nodes;
  for (auto k = frame.offsets[line]; k < frame.offsets[line + 1]; ++k)
    nodes.emplace_back(&frame.points[3 * k]);
  append_fiber(state, {nodes, material_of_radius(state, radius)});
}

}  // namespace

PolyFrame fiber_frame(const FiberState& state) {
  PolyFrame frame;
  frame.time = state.time;
  frame.points.reserve(3 * state.position.size());
  for (const Vec3& point : state.position)
    frame.points.insert(frame.points.end(), point.data(), point.data() + 3);
  const std::span<const Index> offsets = numbers(state.first_node);
  frame.offsets.assign(offsets.begin(), offsets.end());
  std::vector<float> lengths;
  std::vector<std::int32_t> materials;
  std::vector<double> radii;
  for (const FiberIndex fiber : state.fibers()) {
    lengths.push_back(static_cast<float>(fiber_length(state, fiber)));
    materials.push_back(state.material_id[fiber]);
    radii.push_back(state.material(fiber).radius);
  }
  frame.point_data = {{"relative_velocity", "m/s", 3, velocities(state)},
                      {"curvature", "1/m", 1, curvatures(state)}};
  frame.cell_data = {{"birth_id", "1", 1, state.birth_id},
                     {"birth_node", "1", 1, state.birth_node},
                     {"length", "m", 1, std::move(lengths)},
                     {"material", "1", 1, std::move(materials)},
                     {"radius", "m", 1, std::move(radii)}};
  frame.frame_data = {{"lattice", "m", 9, lattice_rows(state.cell)}};
  return frame;
}

FiberState fibers_of(const PolyFrame& frame) {
  FiberState state;
  state.time = frame.time;
  const std::vector<double> lattice = numbers_of(frame.frame_data, "lattice");
  const std::vector<double> radii = numbers_of(frame.cell_data, "radius");
  for (std::size_t i = 0; i < 9; ++i)
    state.cell.lattice(static_cast<int>(i) / 3, static_cast<int>(i) % 3) = lattice.at(i);
  for (std::size_t line = 0; line + 1 < frame.offsets.size(); ++line)
    append_polyline(state, frame, line, radii.at(line));
  const std::vector<double> birth = numbers_of(frame.cell_data, "birth_id");
  const std::vector<double> node = numbers_of(frame.cell_data, "birth_node");
  std::transform(birth.begin(), birth.end(), state.birth_id.begin(),
                 [](double id) { return static_cast<std::uint32_t>(id); });
  std::transform(node.begin(), node.end(), state.birth_node.begin(),
                 [](double id) { return static_cast<std::uint32_t>(id); });
  return state;
}

std::vector<double> numbers_of(const std::vector<FrameArray>& arrays, const std::string& name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(),
                                  [&name](const FrameArray& array) { return array.name == name; });
  if (found == arrays.end()) throw StorageError("a frame has no array " + name);
  return std::visit([](const auto& values) { return std::vector<double>(values.begin(), values.end()); },
                    found->values);
}

}  // namespace fiberfate
