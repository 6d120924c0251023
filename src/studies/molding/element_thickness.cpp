// Matches tables of thickness with the elements of a mesh.
#include "studies/molding/element_thickness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.hpp"
#include "io/input_file.hpp"
#include "io/number_file.hpp"
#include "io/surface_file.hpp"

namespace fiberfate {
namespace {

constexpr double thickest = 0.1;  // m; more is a mistake in the unit
/// Elements of one fault that are listed; of a thousand alike a few are enough.
constexpr std::size_t most_listed = 3;

/// Lists the elements that have a fault: "elements 3, 4, 5 and 283 more have no thickness".
std::string told(const std::vector<std::size_t>& elements, const char* one, const char* many) {
  if (elements.empty()) return "";
  const std::size_t listed = std::min(elements.size(), most_listed);
  std::string text =
      fmt::format("element{} {}", elements.size() > 1 ? "s" : "",
                  fmt::join(elements.begin(), elements.begin() + static_cast<std::ptrdiff_t>(listed), ", "));
  if (elements.size() > listed) text += fmt::format(" and {} more", elements.size() - listed);
  return text + ' ' + (elements.size() > 1 ? many : one);
}

/// Reads the table; raises its faults under the key, with file and line in the complaint.
ElementData read_table(const std::string& path, const std::string& key) {
  ElementData data;
  try {
    for (const NumberRow& row : read_number_file(path, 2)) {
      const double element = row.numbers[0];
      if (!(element >= 1) || element != std::floor(element) || element > 1e15)
        throw InputError({{path, row.line, 1, "", "", fmt::format("{:g} is no element's number", element),
                           "give rows of an element's number and its thickness"}});
      data.elements.push_back(static_cast<std::size_t>(element));
      data.values.push_back(row.numbers[1]);
    }
  } catch (const InputError& error) {
    std::vector<InputProblem> problems;
    for (const InputProblem& one : error.problems())
      problems.push_back({"", 0, 0, key, "", complaint_with_place(one), one.remedy});
    throw InputError(problems);
  }
  return data;
}

ElementData read_data(const PartChoices& part, const std::string& key) {
  if (key == "part.thickness_file") return read_table(part.thickness_file, key);
  try {
    return read_element_data(part.file, part.thickness_data);
  } catch (const InputError& error) {
    const InputProblem& one = error.problems().front();
    throw InputError({{"", 0, 0, key, "", complaint_with_place(one), one.remedy}});
  }
}

}  // namespace

std::vector<double> element_thickness(const PartChoices& part, const SurfaceMesh& mesh) {
  const std::string key = part.thickness_file.empty() ? "part.thickness_data" : "part.thickness_file";
  const ElementData data = read_data(part, key);
  std::map<std::size_t, std::size_t> triangle_of;
  for (std::size_t t = 0; t < mesh.numbers.size(); ++t) triangle_of[mesh.numbers[t]] = t;
  std::vector<double> thickness(mesh.triangles.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<std::size_t> foreign, twice, wrong, missing;
  for (std::size_t i = 0; i < data.elements.size(); ++i) {
    const std::size_t element = data.elements[i];
    const auto found = triangle_of.find(element);
    if (found == triangle_of.end()) {
      foreign.push_back(element);
      continue;
    }
    double& here = thickness[found->second];
    if (!std::isnan(here)) twice.push_back(element);
    here = data.values[i] * part.file_unit;
    if (!(here > 0) || here > thickest) wrong.push_back(element);
  }
  for (std::size_t t = 0; t < thickness.size(); ++t)
    if (std::isnan(thickness[t])) missing.push_back(mesh.numbers[t]);
  std::vector<std::string> faults = {
      told(missing, "has no thickness", "have no thickness"),
      told(wrong, "is not above 0 and at most 100 mm thick", "are not above 0 and at most 100 mm thick"),
      told(twice, "has two thicknesses", "have two thicknesses"),
      told(foreign, "is no triangle of the mesh", "are no triangles of the mesh")};
  std::erase(faults, "");
  if (!faults.empty())
    throw InputError({{"", 0, 0, key, "", fmt::format("{}", fmt::join(faults, "; ")),
                       "give every triangle of the mesh one thickness, in units of part.file_unit"}});
  return thickness;
}

}  // namespace fiberfate
