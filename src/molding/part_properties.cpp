// Averages of aligned composites over lengths, orientations, layers and nodes.
#include "molding/part_properties.hpp"

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
  explicit AlignedTable(const PartSolid& solid) : diameter_(solid.fiber_diameter) {
    for (std::size_t i = 0; i < count_; ++i)
      entries_.push_back(
          aligned_composite(solid.composite, std::exp(step_ * static_cast<double>(i)), solid.model));
  }
  /// The composite of fibers of a length (m).
  [[nodiscard]] ThermoelasticProperties at(double length) const {
    const double place =
        std::clamp(std::log(length / diameter_) / step_, 0.0, static_cast<double>(count_ - 1) - 1e-9);
    const auto below = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(below);
    const ThermoelasticProperties &a = entries_[below], &b = entries_[below + 1];
    return {a.stiffness + share * (b.stiffness - a.stiffness),
            a.thermal_stress + share * (b.thermal_stress - a.thermal_stress)};
  }

 private:
  static constexpr std::size_t count_ = 64;
  static constexpr double step_ = 0.12;  ///< up to an aspect ratio of 1900
  double diameter_;
  std::vector<ThermoelasticProperties> entries_;
};

/// Averages the aligned composite over the lengths at a point; means are represented by L_W.
ThermoelasticProperties aligned_at(const FilledLengths& lengths, const AlignedTable& table, std::size_t node,
                                   std::size_t layer) {
  if (lengths.reading() == LengthReading::means) {
    const MeanLengths means = lengths.set_count() > 0 ? lengths.means(0, node, layer) : lengths.inlet_means();
    return table.at(means.weight_average);
  }
  const LengthClasses population =
      lengths.set_count() > 0 ? lengths.population(0, node, layer) : lengths.inlet_population();
  ThermoelasticProperties sum;
  double shares = 0;
  for (std::size_t c = 0; c < population.lengths.size(); ++c) {
    const double share = population.numbers[c] * population.lengths[c];
    if (!(share > 0)) continue;
    const ThermoelasticProperties one = table.at(population.lengths[c]);
    sum.stiffness += share * one.stiffness;
    sum.thermal_stress += share * one.thermal_stress;
    shares += share;
  }
  return {sum.stiffness / shares, sum.thermal_stress / shares};
}

/// Layers of half the gap, from the mid-plane outwards.
struct LayerRange {
  std::size_t first = 0;
  std::size_t end = 0;
};

/// The share of half the gap that layers take.
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

ThermoelasticProperties node_properties(const FilledLengths& lengths, const AlignedTable& table,
                                        std::size_t node, const LayerRange& range) {
  ThermoelasticProperties sum;
  const GapLayers& layers = lengths.filling().layers();
  const Closure closure = lengths.filling().params().fibers.orientation->closure;
  for (std::size_t layer = range.first; layer < range.end; ++layer) {
    const Mat3 second = lengths.filling().orientation(node, layer);
    const ThermoelasticProperties one =
        orientation_average(aligned_at(lengths, table, node, layer), close(second, closure), second);
    const double share = layers.widths()[layer] / share_of(layers, range);
    sum.stiffness += share * one.stiffness;
    sum.thermal_stress += share * one.thermal_stress;
  }
  return sum;
}

Mat3 node_orientation(const FilledLengths& lengths, std::size_t node, const LayerRange& range) {
  Mat3 sum = Mat3::Zero();
  for (std::size_t layer = range.first; layer < range.end; ++layer)
    sum += lengths.filling().layers().widths()[layer] * lengths.filling().orientation(node, layer);
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
  const auto at = [&](std::size_t k) { return shell.nodes[shell.triangles[triangle][k]]; };
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

std::vector<TriangleProperties> properties_of(const FilledLengths& lengths, const PartSolid& solid,
                                              const LayerRange& range) {
  const AlignedTable table(solid);
  const Shell& shell = lengths.filling().mesh().shell();
  std::vector<ThermoelasticProperties> by_node(shell.nodes.size(), matrix_properties(solid.composite));
  parallel_for(by_node.size(), [&](std::size_t node) {
    if (lengths.is_wet(node)) by_node[node] = node_properties(lengths, table, node, range);
  });
  std::vector<TriangleProperties> properties(shell.triangles.size());
  parallel_for(properties.size(), [&](std::size_t triangle) {
    ThermoelasticProperties mean;
    Mat3 second = Mat3::Zero();
    for (const std::size_t node : shell.triangles[triangle]) {
      mean.stiffness += by_node[node].stiffness / 3;
      mean.thermal_stress += by_node[node].thermal_stress / 3;
      if (lengths.is_wet(node)) second += node_orientation(lengths, node, range) / 3;
    }
    properties[triangle] = in_axes(mean, material_axes(shell, triangle, second));
  });
  return properties;
}

}  // namespace

std::vector<TriangleProperties> triangle_properties(const FilledLengths& lengths, const PartSolid& solid) {
  return properties_of(lengths, solid, {0, lengths.filling().layers().count()});
}

std::vector<Ply> plies(const FilledLengths& lengths, const PartSolid& solid) {
  const GapLayers& layers = lengths.filling().layers();
  std::vector<Ply> all;
  for (const LayerRange& range : ply_ranges(layers))
    all.push_back({share_of(layers, range), properties_of(lengths, solid, range)});
  return all;
}

}  // namespace fiberfate
