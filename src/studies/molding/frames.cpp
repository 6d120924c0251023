// Frames of fillings.
#include "studies/molding/frames.hpp"

#include <limits>

#include "microstructure/tensor.hpp"
#include "studies/molding/observables.hpp"

namespace fiberfate {
namespace {

constexpr float never = std::numeric_limits<float>::quiet_NaN();

float single(double value) {
  return static_cast<float>(value);
}

FrameArray node_array(const std::string& name, const std::string& unit, const MoldingFields& fields,
                      const std::vector<double>& values) {
  std::vector<float> numbers(values.size(), never);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (fields.is_wet(i)) numbers[i] = single(values[i]);
  return {name, unit, 1, std::move(numbers)};
}

/// A2 over the gap by node, six components.
FrameArray orientation_array(const MoldingFields& fields) {
  const std::size_t nodes = fields.filling().mesh().node_count();
  std::vector<float> numbers(6 * nodes, never);
  for (std::size_t i = 0; i < nodes; ++i) {
    if (!fields.is_wet(i)) continue;
    const Vec6 components = to_components(fields.filling().mean_orientation(i));
    for (int k = 0; k < 6; ++k) numbers[6 * i + k] = single(components[k]);
  }
  return {"A2", "1", 6, std::move(numbers)};
}

void add_lengths(const MoldingFields& fields, std::size_t set, const std::string& suffix, PolyFrame& frame) {
  const std::size_t nodes = fields.filling().mesh().node_count();
  std::vector<double> number(nodes), weight(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const MeanLengths means = fields.means(set, i);
    number[i] = means.number_average;
    weight[i] = means.weight_average;
  }
  frame.point_data.push_back(node_array("L_N" + suffix, "m", fields, number));
  frame.point_data.push_back(node_array("L_W" + suffix, "m", fields, weight));
}

/// The values of a field over all levels from wall to wall, node by node of each.
FrameArray layered_array(const MoldingFields& fields, const GapField& field, std::size_t nodes,
                         std::size_t half) {
  std::vector<float> numbers;
  for (std::size_t level = 0; level < 2 * half; ++level) {
    const std::size_t layer = level < half ? half - 1 - level : level - half;
    for (std::size_t i = 0; i < nodes; ++i)
      numbers.push_back(fields.is_wet(i) ? single(field.profile.measure({fields, i, layer})) : never);
  }
  return {field.array, field.profile.unit.empty() ? "1" : field.profile.unit, 1, std::move(numbers)};
}

}  // namespace

PolyFrame shell_frame(const Filling& filling) {
  const Shell& shell = filling.mesh().shell();
  PolyFrame frame;
  frame.time = filling.state().time;
  frame.shape = CellShape::polygon;
  for (const Vec3& node : shell.nodes) frame.points.insert(frame.points.end(), node.data(), node.data() + 3);
  frame.offsets = {0};
  for (const auto& triangle : shell.triangles) {
    frame.connectivity.insert(frame.connectivity.end(), triangle.begin(), triangle.end());
    frame.offsets.push_back(static_cast<std::int64_t>(frame.connectivity.size()));
  }
  return frame;
}

PolyFrame part_frame(const MoldingFields& fields, FrameGeometry geometry) {
  const Filling& filling = fields.filling();
  const FillingState& state = filling.state();
  PolyFrame frame = shell_frame(filling);
  frame.geometry = geometry;
  std::vector<float> fill_time(state.fill_time.begin(), state.fill_time.end());
  std::vector<float> pressure(state.pressure.begin(), state.pressure.end());
  std::vector<std::int32_t> mark;
  for (const NodeMark one : state.mark) mark.push_back(static_cast<std::int32_t>(one));
  frame.point_data = {{"fill_time", "s", 1, std::move(fill_time)},
                      {"pressure", "Pa", 1, std::move(pressure)},
                      {"mark", "1", 1, std::move(mark)},
                      node_array("temperature", "K", fields, filling.gap_average(state.temperature)),
                      node_array("rate", "1/s", fields, filling.gap_average(state.rate))};
  if (fields.setup().params.fibers.orientation) frame.point_data.push_back(orientation_array(fields));
  if (fields.set_count() > 0) add_lengths(fields, 0, "", frame);
  if (fields.setup().compared_set >= 0) add_lengths(fields, fields.setup().compared_set, "_compared", frame);
  frame.frame_data = {{"filled_fraction", "1", 1, std::vector<double>{filling.filled_fraction()}}};
  return frame;
}

PrismMesh layer_prisms(const MoldingFields& fields) {
  const ShellMesh& mesh = fields.filling().mesh();
  const std::span<const double> middles = fields.filling().layers().middles();
  const std::size_t half = middles.size();
  PrismMesh prisms;
  for (std::size_t level = 0; level < 2 * half; ++level) {
    const double height = level < half ? -middles[half - 1 - level] : middles[level - half];
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
      const Vec3 at = mesh.shell().nodes[i] + 0.5 * height * mesh.thickness(i) * mesh.frame(i).col(2);
      prisms.points.insert(prisms.points.end(), at.data(), at.data() + 3);
    }
  }
  prisms.levels = 2 * half;
  prisms.triangles = mesh.shell().triangles;
  for (const GapField& field : gap_fields())
    if (!field.array.empty() && follows(fields, field.of))
      prisms.point_data.push_back(layered_array(fields, field, mesh.node_count(), half));
  return prisms;
}

}  // namespace fiberfate
