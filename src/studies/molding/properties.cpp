// Takes properties from a case and makes frames of them.
#include "studies/molding/properties.hpp"

#include "studies/molding/frames.hpp"

namespace fiberfate {
bool has_properties(const MoldingCase& values) {
  const MoldingFiberChoices& fibers = values.fibers;
  return !values.orientation.name.empty() &&
         (fibers.length || fibers.number_average || !fibers.distribution.empty());
}

PartSolid solid_of(const MoldingCase& values) {
  const CompositeChoices& composite = values.composite;
  return {{.fiber = composite.fiber,
           .matrix = composite.matrix,
           .fiber_expansion = composite.fiber_expansion,
           .matrix_expansion = composite.matrix_expansion,
           .volume_fraction = values.fibers.volume_fraction},
          composite.model,
          values.fibers.diameter};
}

PolyFrame properties_frame(const Filling& filling, const std::vector<TriangleProperties>& properties) {
  PolyFrame frame = shell_frame(filling);
  std::vector<float> direction;
  for (const TriangleProperties& one : properties)
    for (int k = 0; k < 3; ++k) direction.push_back(static_cast<float>(one.axes(k, 0)));
  using Properties = const TriangleProperties&;
  const auto add = [&](const char* name, const char* unit, double (*value)(Properties)) {
    std::vector<float> numbers;
    for (Properties one : properties) numbers.push_back(static_cast<float>(value(one)));
    frame.cell_data.push_back({name, unit, 1, std::move(numbers)});
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
