// Starts and ends Gmsh and collects the triangles of its model.
#include "io/gmsh_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr int triangle_type = 2;  // of Gmsh: flat, three nodes

/// The name of an element of Gmsh that surfaces hold besides triangles.
std::string element_name(int type) {
  if (type == 3) return "quadrangles";
  if (type == 9) return "triangles of second order";
  return type == 10 || type == 16 ? "quadrangles of second order"
                                  : fmt::format("elements of Gmsh's type {}", type);
}

void require_triangles(const GmshLibrary& gmsh, const std::string& name) {
  GmshList<int> types(gmsh);
  gmsh.call(gmsh.element_types, &types.items, &types.count, 2, -1);
  for (const int type : types.values())
    if (type != triangle_type)
      throw InputError(fmt::format("{}: its surfaces hold {}", name, element_name(type)),
                       "mesh the part with triangles of three nodes (order 1, not recombined)");
}

/// The name of a surface's region: its first physical group, or else its number.
std::string region_of(const GmshLibrary& gmsh, int surface) {
  GmshList<int> groups(gmsh);
  gmsh.call(gmsh.groups_of, 2, surface, &groups.items, &groups.count);
  if (groups.count == 0) return fmt::format("surface {}", surface);
  char* text = nullptr;
  gmsh.call(gmsh.group_name, 2, groups.items[0], &text);
  const std::string found = text == nullptr ? "" : text;
  gmsh.free(text);
  return found.empty() ? fmt::format("group {}", groups.items[0]) : found;
}

Index region_index(SurfaceMesh& mesh, const std::string& region) {
  std::vector<std::string>& names = mesh.region_names;
  const auto index = std::find(names.begin(), names.end(), region) - names.begin();
  if (index == std::ssize(names)) names.push_back(region);
  return static_cast<Index>(index);
}

/// Appends the triangles of one surface, by tags of nodes.
void append_surface(const GmshLibrary& gmsh, int surface, SurfaceMesh& mesh,
                    std::vector<std::size_t>& corners) {
  GmshList<std::size_t> elements(gmsh), nodes(gmsh);
  gmsh.call(gmsh.elements, triangle_type, &elements.items, &elements.count, &nodes.items, &nodes.count,
            surface, std::size_t{0}, std::size_t{1});
  if (elements.count == 0) return;
  corners.insert(corners.end(), nodes.items, nodes.items + nodes.count);
  mesh.numbers.insert(mesh.numbers.end(), elements.items, elements.items + elements.count);
  mesh.regions.insert(mesh.regions.end(), elements.count, region_index(mesh, region_of(gmsh, surface)));
}

/// Numbers the nodes that triangles use, in order of their tags.
void number_points(const GmshLibrary& gmsh, const std::vector<std::size_t>& corners, double unit,
                   SurfaceMesh& mesh) {
  GmshList<std::size_t> tags(gmsh);
  GmshList<double> coordinates(gmsh), parameters(gmsh);
  gmsh.call(gmsh.nodes, &tags.items, &tags.count, &coordinates.items, &coordinates.count, &parameters.items,
            &parameters.count, -1, -1, 0, 0);
  std::map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < tags.count; ++i) place[tags.items[i]] = i;
  std::vector<std::size_t> used = corners;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const std::size_t tag : used) {
    const auto found = place.find(tag);
    if (found == place.end()) throw GmshError(fmt::format("a triangle names node {}, which is none", tag));
    const double* at = coordinates.items + 3 * found->second;
    mesh.points.emplace_back(unit * at[0], unit * at[1], unit * at[2]);
  }
  const auto index_of = [&used](std::size_t tag) {
    return static_cast<Index>(std::lower_bound(used.begin(), used.end(), tag) - used.begin());
  };
  for (std::size_t i = 0; i < corners.size(); i += 3)
    mesh.triangles.push_back({index_of(corners[i]), index_of(corners[i + 1]), index_of(corners[i + 2])});
}

/// The name of a view in the file.
std::string name_of_view(const GmshLibrary& gmsh, int tag) {
  const std::string option = fmt::format("View[{}].Name", gmsh.call(gmsh.view_index, tag));
  char* text = nullptr;
  gmsh.call(gmsh.text_option, option.c_str(), &text);
  const std::string found = text == nullptr ? "" : text;
  gmsh.free(text);
  return found;
}

}  // namespace

GmshSession::GmshSession() : library_(gmsh_library()) {
  constexpr int read_config_files = 0;  // a user's own settings would change the mesh
  library_.call(library_.initialize, 0, nullptr, read_config_files);
  library_.call(library_.set_option, "General.Terminal", 0.0);
  library_.call(library_.set_option, "General.NumThreads", 1.0);
}

GmshSession::~GmshSession() {
  int ignored = 0;
  library_.finalize(&ignored);
}

SurfaceMesh take_triangles(const GmshSession& session, const std::string& name, double unit) {
  const GmshLibrary& gmsh = session.library();
  require_triangles(gmsh, name);
  GmshList<int> surfaces(gmsh);  // dimension and tag of each
  gmsh.call(gmsh.entities, &surfaces.items, &surfaces.count, 2);
  SurfaceMesh mesh;
  std::vector<std::size_t> corners;
  for (std::size_t i = 1; i < surfaces.count; i += 2) append_surface(gmsh, surfaces.items[i], mesh, corners);
  if (corners.empty())
    throw InputError(name + ": there are no triangles",
                     "give a surface mesh; volumes and lines are not read");
  number_points(gmsh, corners, unit, mesh);
  return mesh;
}

ElementData take_element_data(const GmshSession& session, const std::string& name, const std::string& view) {
  const GmshLibrary& gmsh = session.library();
  GmshList<int> tags(gmsh);
  gmsh.call(gmsh.views, &tags.items, &tags.count);
  std::vector<std::string> others;
  for (const int tag : tags.values()) {
    others.push_back('"' + name_of_view(gmsh, tag) + '"');
    if (others.back() != '"' + view + '"') continue;
    char* kind = nullptr;
    GmshList<std::size_t> elements(gmsh);
    GmshList<double> values(gmsh);
    double time = 0;
    int components = 0;
    gmsh.call(gmsh.view_data, tag, 0, &kind, &elements.items, &elements.count, &values.items, &values.count,
              &time, &components);
    const std::string found = kind == nullptr ? "" : kind;
    gmsh.free(kind);
    if (found != "ElementData" || components != 1)
      throw InputError(fmt::format("{}: \"{}\" is {} of {} components", name, view, found, components),
                       "give one number an element ($ElementData)");
    return {elements.values(), values.values()};
  }
  throw InputError(fmt::format("{}: there is no data \"{}\"", name, view),
                   others.empty() ? "add a section $ElementData to the file"
                                  : fmt::format("it has {}", fmt::join(others, ", ")));
}

}  // namespace fiberfate
