// The part in space: the last state's places, layers and axes on top of what happens while it fills.
#include "studies/molding/part_section.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/constants.hpp"
#include "io/vtkhdf_file.hpp"
#include "molding/weld_lines.hpp"
#include "results/fiber_frame.hpp"
#include "studies/molding/checkpoint.hpp"
#include "studies/molding/setup.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t most_values = 1'500'000;        // of one field over all times that a page can carry
constexpr std::size_t most_layer_values = 2'000'000;  // of all fields and layers together: some 11 MB of HTML

/// An array of result.vtkhdf as the page shows it.
struct ShownField {
  const char *array, *label, *unit;
  int component = 0;
  double offset = 0;
  enum class Times { all, last } times = Times::all;
};

constexpr ShownField shown_fields[] = {
    {"fill_time", "fill time", "s", 0, 0, ShownField::Times::last},
    {"pressure", "pressure", "Pa"},
    {"temperature", "temperature, mean over the gap", "degC", 0, -zero_celsius},
    {"L_N", "length L_N", "m"},
    {"L_W", "length L_W", "m"},
    {"L_N_compared", "length L_N, compared law", "m", 0, 0, ShownField::Times::last},
    {"A2", "orientation a_11", "1", 0},
    {"A2", "orientation a_22", "1", 1},
    {"A2", "orientation a_33", "1", 2}};

/// An array of layers.vtkhdf as the page shows it.
struct LayerField {
  const char *array, *label, *unit;
  double offset = 0;
};
constexpr LayerField layer_fields[] = {{"temperature", "temperature", "degC", -zero_celsius},
                                       {"rate", "shear rate", "1/s"},
                                       {"A11", "orientation a_11", "1"},
                                       {"A22", "orientation a_22", "1"},
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

/// The values of one component; empty where a frame has no such array.
std::vector<float> component_of(const PolyFrame& frame, const ShownField& shown) {
  std::vector<float> values;
  for (const FrameArray& array : frame.point_data) {
    if (array.name != shown.array) continue;
    const std::vector<double> all = numbers_of({array}, array.name);
    for (auto i = static_cast<std::size_t>(shown.component); i < all.size();
         i += static_cast<std::size_t>(array.components))
      values.push_back(static_cast<float>(all[i] + shown.offset));
  }
  return values;
}

/// Chooses frames so that a page can carry them: all, or every second, third, … and the last.
std::vector<std::size_t> chosen_frames(std::size_t frames, std::size_t nodes) {
  const std::size_t every = 1 + frames * nodes / most_values;
  std::vector<std::size_t> chosen;
  for (std::size_t i = (frames - 1) % every; i < frames; i += every) chosen.push_back(i);
  return chosen;
}

/// Adds the fields over time, or at the last time where that tells all.
void add_fields(const VtkhdfReader& reader, const std::vector<std::size_t>& frames, ShellSection& section) {
  std::vector<ShellField> fields;
  for (const ShownField& shown : shown_fields) fields.push_back({shown.label, shown.unit, {}});
  for (const std::size_t index : frames) {
    const PolyFrame frame = reader.read(index);
    for (std::size_t f = 0; f < fields.size(); ++f) {
      if (shown_fields[f].times == ShownField::Times::last && index != frames.back()) continue;
      std::vector<float> values = component_of(frame, shown_fields[f]);
      if (!values.empty()) fields[f].frames.push_back(std::move(values));
    }
  }
  std::erase_if(fields, [](const ShellField& field) { return field.frames.empty(); });
  section.fields = std::move(fields);
}

/// Adds the layers of layers.vtkhdf, where a run has written it and a page can carry it.
void add_layers(const ResultFolder& folder, const ShellMesh& mesh, ShellSection& section) {
  const std::string path = folder.file("layers.vtkhdf");
  if (!std::filesystem::exists(path)) return;
  const Hdf5File file = Hdf5File::open(path, Hdf5File::Access::read);
  const std::size_t nodes = mesh.node_count();
  const std::vector<double> points = file.read<double>("VTKHDF/Points");
  if (points.size() / 6 * std::size(layer_fields) > most_layer_values) return;
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

/// Adds the axes of properties.vtkhdf along which triangles are stiffest, where a run has written it.
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
        middle += section.points[3 * section.triangles[3 * t + corner] + k] / 3;
      stiff.at.push_back(middle);
      stiff.vectors.push_back(axes[3 * t + k] * moduli[t]);
    }
  }
  if (!stiff.at.empty()) section.directions.push_back(std::move(stiff));
}

/// Adds places and weld lines out of the last state, and the layers, whose thickness only its shell tells.
void add_last_state(const MoldingCase& values, const ResultFolder& folder, ShellSection& section) {
  const MoldingCheckpoint last = load_molding(folder);
  const ShellMesh mesh(last.shell);
  add_layers(folder, mesh, section);
  const MoldingSetup setup = molding_setup(values, last.shell);
  for (const Gate& gate : setup.params.gates)
    section.places.push_back(
        {gate.name, PlaceMark::gate, gate.end ? Vec3(0.5 * (gate.position + *gate.end)) : gate.position});
  for (const NamedPlace& place : values.output.places)
    section.places.push_back({place.name, PlaceMark::place, position_of(place, setup.part)});
  ShellLines weld = {"weld lines", {}};
  for (const LinePiece& piece : weld_lines(mesh, last.state))
    for (const Vec3& end : piece)
      for (int axis = 0; axis < 3; ++axis) weld.segments.push_back(static_cast<float>(end[axis]));
  if (!weld.segments.empty()) section.lines.push_back(std::move(weld));
  for (std::size_t i = 0; i < last.state.mark.size(); ++i) {
    if (last.state.mark[i] == NodeMark::air_trap)
      section.places.push_back({"", PlaceMark::trap, last.shell.nodes[i]});
    if (last.state.mark[i] == NodeMark::last_filled)
      section.places.push_back({"last filled", PlaceMark::place, last.shell.nodes[i]});
  }
}

}  // namespace

ShellSection part_section(const MoldingCase& values, const ResultFolder& folder) {
  const VtkhdfReader reader(folder.frames());
  const PolyFrame last = reader.read(reader.times().size() - 1);
  ShellSection section;
  section.id = "part";
  section.title = "The part while it fills";
  section.points.assign(last.points.begin(), last.points.end());
  section.triangles.assign(last.connectivity.begin(), last.connectivity.end());
  section.fill_time = component_of(last, shown_fields[0]);
  const std::vector<std::size_t> frames = chosen_frames(reader.times().size(), last.points.size() / 3);
  for (const std::size_t frame : frames) section.times.push_back(reader.times()[frame]);
  add_fields(reader, frames, section);
  for (const FrameArray& array : last.point_data) {
    if (array.name != "A2") continue;
    const std::vector<double> all = numbers_of({array}, array.name);
    section.tensors.push_back({"orientation", {all.begin(), all.end()}});
  }
  // A run that was killed may have none yet.
  if (std::filesystem::exists(folder.checkpoint())) add_last_state(values, folder, section);
  add_stiffness_axes(folder, section);
  section.caption =
      "Values between the frames are interpolated; temperature, length and orientation are means over the "
      "gap. Red squares are gates, red rings likely air traps.";
  return section;
}

}  // namespace fiberfate
