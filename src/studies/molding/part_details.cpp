// Adds to the picture of a part what its last state holds: orientation as tensors, profiles through the gap,
// axes of stiffness.
#include "studies/molding/part_details.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/hdf5_file.hpp"
#include "results/fiber_frame.hpp"

namespace fiberfate {
namespace {

constexpr double zero_celsius = 273.15;         // K
constexpr std::size_t most_values = 2'000'000;  // of all fields and layers together: some 11 MB of HTML

/// An array of layers.vtkhdf as the page shows it.
struct LayerField {
  const char *array, *label, *unit;
  double offset = 0;
};
constexpr LayerField layer_fields[] = {{"temperature", "temperature", "degC", -zero_celsius},
                                       {"rate", "shear rate", "1/s"},
                                       {"A11", "orientation A_11", "1"},
                                       {"A22", "orientation A_22", "1"},
                                       {"L_N", "length L_N", "m"},
                                       {"L_W", "length L_W", "m"}};

/// Picks the upper half of a stack of levels, layer by layer of each node.
std::vector<float> upper_half(const std::vector<float>& levels, std::size_t nodes, double offset) {
  const std::size_t half = levels.size() / nodes / 2;
  std::vector<float> values;
  values.reserve(nodes * half);
  for (std::size_t node = 0; node < nodes; ++node)
    for (std::size_t layer = 0; layer < half; ++layer)
      values.push_back(static_cast<float>(levels[(half + layer) * nodes + node] + offset));
  return values;
}

/// Measures the heights of the layers over half of the thickness; they are the same at all nodes.
std::vector<double> layer_heights(const std::vector<double>& points, std::size_t nodes, double thickness) {
  const std::size_t half = points.size() / 3 / nodes / 2;
  const auto point = [&](std::size_t level) { return Vec3(&points[3 * level * nodes]); };
  std::vector<double> heights;
  for (std::size_t layer = 0; layer < half; ++layer)
    heights.push_back((point(half + layer) - point(half - 1 - layer)).norm() / thickness);
  return heights;
}

}  // namespace

void add_orientation(const PolyFrame& last, ShellSection& section) {
  for (const FrameArray& array : last.point_data) {
    if (array.name != "A2") continue;
    ShellTensors tensors{"orientation", {}};
    for (const double value : numbers_of({array}, "A2")) tensors.values.push_back(static_cast<float>(value));
    section.tensors.push_back(std::move(tensors));
  }
}

void add_layers(const ResultFolder& folder, const ShellMesh& mesh, ShellSection& section) {
  const std::string path = folder.file("layers.vtkhdf");
  if (!std::filesystem::exists(path)) return;
  const Hdf5File file = Hdf5File::open(path, Hdf5File::Access::read);
  const std::size_t nodes = mesh.node_count();
  const std::vector<double> points = file.read<double>("VTKHDF/Points");
  if (points.size() / 6 * std::size(layer_fields) > most_values) return;
  ShellLayers layers{layer_heights(points, nodes, mesh.thickness(0)), {}, {}};
  for (std::size_t node = 0; node < nodes; ++node)
    layers.thickness.push_back(static_cast<float>(mesh.thickness(node)));
  for (const LayerField& field : layer_fields) {
    const std::string name = std::string("VTKHDF/PointData/") + field.array;
    if (!file.contains(name)) continue;
    layers.fields.push_back(
        {field.label, field.unit, upper_half(file.read<float>(name), nodes, field.offset)});
  }
  section.layers = std::move(layers);
}

void add_stiffness_axes(const ResultFolder& folder, ShellSection& section) {
  const std::string path = folder.file("properties.vtkhdf");
  if (!std::filesystem::exists(path)) return;
  const Hdf5File file = Hdf5File::open(path, Hdf5File::Access::read);
  const std::vector<float> axes = file.read<float>("VTKHDF/CellData/axis_1");
  const std::vector<float> moduli = file.read<float>("VTKHDF/CellData/E_1");
  ShellDirections stiff{"stiffest direction", "Pa", {}, {}};
  for (std::size_t t = 0; t < moduli.size() && 3 * t + 2 < section.triangles.size(); ++t) {
    if (!std::isfinite(moduli[t])) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      float middle = 0;
      for (std::size_t corner = 0; corner < 3; ++corner)
        middle += section.points[3 * static_cast<std::size_t>(section.triangles[3 * t + corner]) + k] / 3;
      stiff.at.push_back(middle);
      stiff.vectors.push_back(axes[3 * t + k] * moduli[t]);
    }
  }
  if (!stiff.at.empty()) section.directions.push_back(std::move(stiff));
}

}  // namespace fiberfate
