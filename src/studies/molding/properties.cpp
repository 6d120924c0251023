// Takes properties from a case and makes frames of them.
#include "studies/molding/properties.hpp"

namespace fiberfate {
namespace {

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

PartSolid solid_of(const MoldingCase& values) {
  PartSolid solid;
  solid.composite.fiber = values.composite.fiber;
  solid.composite.matrix = values.composite.matrix;
  solid.composite.fiber_expansion = values.composite.fiber_expansion;
  solid.composite.matrix_expansion = values.composite.matrix_expansion;
  solid.composite.volume_fraction = values.fibers.volume_fraction;
  solid.model = values.composite.model;
  solid.fiber_diameter = values.fibers.diameter;
  return solid;
}

PolyFrame properties_frame(const Filling& filling, const std::vector<TriangleProperties>& properties) {
  const Shell& shell = filling.mesh().shell();
  PolyFrame frame;
  frame.time = filling.state().time;
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
