// Averages properties over lengths, orientations, layers and nodes.
#include "studies/molding/properties.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "microstructure/closure.hpp"
#include "microstructure/eigenframe.hpp"

namespace fiberfate {
namespace {

/// Plies into which half the gap is parted for solvers of structures.
constexpr std::size_t plies_of_half_gap = 4;

/// Tabulates aligned composites over the aspect ratio; stiffness is smooth in its logarithm.
class AlignedTable {
 public:
  AlignedTable(const CompositeMaterial& material, Homogenisation model) {
    for (std::size_t i = 0; i < count_; ++i)
      entries_.push_back(aligned_composite(material, std::exp(step_ * static_cast<double>(i)), model));
  }
  [[nodiscard]] ThermoelasticProperties at(double aspect_ratio) const {
    const double place =
        std::clamp(std::log(aspect_ratio) / step_, 0.0, static_cast<double>(count_ - 1) - 1e-9);
    const auto below = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(below);
    const ThermoelasticProperties &a = entries_[below], &b = entries_[below + 1];
    return {a.stiffness + share * (b.stiffness - a.stiffness),
            a.thermal_stress + share * (b.thermal_stress - a.thermal_stress)};
  }

 private:
  static constexpr std::size_t count_ = 64;
  static constexpr double step_ = 0.12;  ///< up to an aspect ratio of 1900
  std::vector<ThermoelasticProperties> entries_;
};

CompositeMaterial composite_of(const MoldingCase& values) {
  CompositeMaterial material;
  material.fiber = values.composite.fiber;
  material.matrix = values.composite.matrix;
  material.fiber_expansion = values.composite.fiber_expansion;
  material.matrix_expansion = values.composite.matrix_expansion;
  material.volume_fraction = values.fibers.volume_fraction;
  return material;
}

/// Averages the aligned composite over the lengths at a point; means are represented by L_W.
ThermoelasticProperties aligned_at(const MoldingFields& fields, const AlignedTable& table, std::size_t node,
                                   std::size_t layer) {
  const double diameter = fields.values().fibers.diameter;
  if (fields.setup().reading == LengthReading::means) {
    const MeanLengths means = fields.set_count() > 0 ? fields.means(0, node, layer) : fields.inlet_means();
    return table.at(means.weight_average / diameter);
  }
  const LengthClasses population =
      fields.set_count() > 0 ? fields.population(0, node, layer) : fields.inlet_population();
  ThermoelasticProperties sum;
  double shares = 0;
  for (std::size_t c = 0; c < population.lengths.size(); ++c) {
    const double share = population.numbers[c] * population.lengths[c];
    if (!(share > 0)) continue;
    const ThermoelasticProperties one = table.at(population.lengths[c] / diameter);
    sum.stiffness += share * one.stiffness;
    sum.thermal_stress += share * one.thermal_stress;
    shares += share;
  }
  return {sum.stiffness / shares, sum.thermal_stress / shares};
}

/// Names layers of half the gap, from the mid-plane outwards.
struct LayerRange {
  std::size_t first = 0;
  std::size_t end = 0;
};

/// Tells the share of half the gap that layers take.
double share_of(const GapLayers& layers, const LayerRange& range) {
  return layers.bounds()[range.end] - layers.bounds()[range.first];
}

/// Parts the layers of half the gap into plies of about one thickness, from the mid-plane outwards.
std::vector<LayerRange> ply_ranges(const GapLayers& layers) {
  std::vector<LayerRange> ranges;
  for (std::size_t first = 0, end = 0; first < layers.count(); first = end) {
    const double wanted = static_cast<double>(ranges.size() + 1) / static_cast<double>(plies_of_half_gap);
    for (end = first + 1; end < layers.count() && layers.bounds()[end] < wanted - 1e-9;) ++end;
    ranges.push_back({first, end});
  }
  return ranges;
}

ThermoelasticProperties node_properties(const MoldingFields& fields, const AlignedTable& table,
                                        std::size_t node, const LayerRange& range) {
  ThermoelasticProperties sum;
  const GapLayers& layers = fields.filling().layers();
  const Closure closure = fields.setup().params.fibers.orientation->closure;
  for (std::size_t layer = range.first; layer < range.end; ++layer) {
    const Mat3 second = fields.filling().orientation(node, layer);
    const ThermoelasticProperties one =
        orientation_average(aligned_at(fields, table, node, layer), close(second, closure), second);
    const double share = layers.widths()[layer] / share_of(layers, range);
    sum.stiffness += share * one.stiffness;
    sum.thermal_stress += share * one.thermal_stress;
  }
  return sum;
}

Mat3 node_orientation(const MoldingFields& fields, std::size_t node, const LayerRange& range) {
  Mat3 sum = Mat3::Zero();
  for (std::size_t layer = range.first; layer < range.end; ++layer)
    sum += fields.filling().layers().widths()[layer] * fields.filling().orientation(node, layer);
  return sum;
}

ThermoelasticProperties matrix_properties(const CompositeMaterial& material) {
  ThermoelasticProperties matrix;
  matrix.stiffness = isotropic_stiffness(material.matrix);
  matrix.thermal_stress = contracted(matrix.stiffness, material.matrix_expansion * Mat3::Identity());
  return matrix;
}

/// Makes the axes of a triangle: the largest principal value of A2 in its plane, across it, the normal.
Mat3 material_axes(const Shell& shell, std::size_t triangle, const Mat3& second) {
  const auto at = [&](std::size_t k) {
    return shell.nodes[static_cast<std::size_t>(shell.triangles[triangle][k])];
  };
  Mat3 frame;
  frame.col(2) = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
  frame.col(0) = (at(1) - at(0)).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  const Mat3 local = rotated(second, frame.transpose());
  const double angle = 0.5 * std::atan2(2 * local(0, 1), local(0, 0) - local(1, 1));
  Mat3 axes = frame;
  axes.col(0) = std::cos(angle) * frame.col(0) + std::sin(angle) * frame.col(1);
  axes.col(1) = frame.col(2).cross(axes.col(0));
  return axes;
}

TriangleProperties in_axes(const ThermoelasticProperties& properties, const Mat3& axes) {
  const ThermoelasticProperties turned = {rotated(properties.stiffness, axes.transpose()),
                                          rotated(properties.thermal_stress, axes.transpose())};
  return {axes, engineering_constants(turned.stiffness), thermal_expansion(turned).diagonal()};
}

std::vector<TriangleProperties> properties_of(const MoldingFields& fields, const LayerRange& range) {
  const CompositeMaterial material = composite_of(fields.values());
  const AlignedTable table(material, fields.values().composite.model);
  const Shell& shell = fields.filling().mesh().shell();
  std::vector<ThermoelasticProperties> by_node(shell.nodes.size(), matrix_properties(material));
  parallel_for(static_cast<std::ptrdiff_t>(by_node.size()), [&](std::ptrdiff_t i) {
    const auto node = static_cast<std::size_t>(i);
    if (fields.is_wet(node)) by_node[node] = node_properties(fields, table, node, range);
  });
  std::vector<TriangleProperties> properties(shell.triangles.size());
  parallel_for(static_cast<std::ptrdiff_t>(properties.size()), [&](std::ptrdiff_t t) {
    const auto triangle = static_cast<std::size_t>(t);
    ThermoelasticProperties mean;
    Mat3 second = Mat3::Zero();
    for (const Index index : shell.triangles[triangle]) {
      const auto node = static_cast<std::size_t>(index);
      mean.stiffness += by_node[node].stiffness / 3;
      mean.thermal_stress += by_node[node].thermal_stress / 3;
      if (fields.is_wet(node)) second += node_orientation(fields, node, range) / 3;
    }
    properties[triangle] = in_axes(mean, material_axes(shell, triangle, second));
  });
  return properties;
}

FrameArray triangle_array(const char* name, const char* unit,
                          const std::vector<TriangleProperties>& properties,
                          double (*value)(const TriangleProperties&)) {
  std::vector<float> numbers;
  for (const TriangleProperties& one : properties) numbers.push_back(static_cast<float>(value(one)));
  return {name, unit, 1, std::move(numbers)};
}

}  // namespace

bool has_properties(const MoldingCase& values) {
  const MoldingFiberChoices& fibers = values.fibers;
  return !values.orientation.name.empty() &&
         (fibers.length || fibers.number_average || !fibers.distribution.empty());
}

std::vector<TriangleProperties> triangle_properties(const MoldingFields& fields) {
  return properties_of(fields, {0, fields.filling().layers().count()});
}

std::vector<Ply> plies(const MoldingFields& fields) {
  std::vector<Ply> all;
  for (const LayerRange& range : ply_ranges(fields.filling().layers()))
    all.push_back({share_of(fields.filling().layers(), range), properties_of(fields, range)});
  return all;
}

PolyFrame properties_frame(const MoldingFields& fields, const std::vector<TriangleProperties>& properties) {
  const Shell& shell = fields.filling().mesh().shell();
  PolyFrame frame;
  frame.time = fields.filling().state().time;
  frame.shape = CellShape::polygon;
  frame.offsets = {0};
  for (const Vec3& node : shell.nodes) frame.points.insert(frame.points.end(), node.data(), node.data() + 3);
  std::vector<float> direction;
  for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
    frame.connectivity.insert(frame.connectivity.end(), shell.triangles[t].begin(), shell.triangles[t].end());
    frame.offsets.push_back(static_cast<std::int64_t>(frame.connectivity.size()));
    for (int k = 0; k < 3; ++k) direction.push_back(static_cast<float>(properties[t].axes(k, 0)));
  }
  using Properties = const TriangleProperties&;
  const auto add = [&](const char* name, const char* unit, double (*value)(Properties)) {
    frame.cell_data.push_back(triangle_array(name, unit, properties, value));
  };
  frame.cell_data.push_back({"axis_1", "1", 3, std::move(direction)});
  add("E_1", "Pa", [](Properties one) { return one.constants.e1; });
  add("E_2", "Pa", [](Properties one) { return one.constants.e2; });
  add("E_3", "Pa", [](Properties one) { return one.constants.e3; });
  add("G_12", "Pa", [](Properties one) { return one.constants.g12; });
  add("nu_12", "1", [](Properties one) { return one.constants.nu12; });
  add("alpha_1", "1/K", [](Properties one) { return one.expansion[0]; });
  add("alpha_2", "1/K", [](Properties one) { return one.expansion[1]; });
  return frame;
}

}  // namespace fiberfate
