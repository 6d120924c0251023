// Starts and ends Gmsh and collects the triangles of its model.
#include "io/gmsh_session.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr int triangle_type = 2;  // of Gmsh: flat, three nodes

std::mutex& session_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// Names the region of a surface: its first physical group, or else its number.
std::string region_of(int surface) {
  std::vector<int> groups;
  gmsh::model::getPhysicalGroupsForEntity(2, surface, groups);
  if (groups.empty()) return fmt::format("surface {}", surface);
  std::string found;
  gmsh::model::getPhysicalName(2, groups.front(), found);
  return found.empty() ? fmt::format("group {}", groups.front()) : found;
}

Index region_index(SurfaceMesh& mesh, const std::string& region) {
  const auto found = std::find(mesh.region_names.begin(), mesh.region_names.end(), region);
  if (found == mesh.region_names.end()) mesh.region_names.push_back(region);
  return static_cast<Index>(std::distance(mesh.region_names.begin(), found));
}

/// Appends the triangles of one surface, by tags of nodes.
void append_surface(const std::string& name, int surface, SurfaceMesh& mesh,
                    std::vector<std::size_t>& corners) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> elements, nodes;
  gmsh::model::mesh::getElements(types, elements, nodes, 2, surface);
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (types[i] != triangle_type) {
      std::string kind;
      int dimension = 0, order = 0, count = 0, primary = 0;
      std::vector<double> local;
      gmsh::model::mesh::getElementProperties(types[i], kind, dimension, order, count, local, primary);
      throw InputError(
          fmt::format("{}: surface {} holds {} elements \"{}\"", name, surface, elements[i].size(), kind),
          "mesh the part with triangles of three nodes (order 1, not recombined)");
    }
    corners.insert(corners.end(), nodes[i].begin(), nodes[i].end());
    mesh.regions.insert(mesh.regions.end(), elements[i].size(), region_index(mesh, region_of(surface)));
  }
}

/// Numbers the nodes that triangles use, in order of their tags.
void number_points(const std::vector<std::size_t>& corners, double unit, SurfaceMesh& mesh) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters);
  std::map<std::size_t, std::size_t> place;
  for (std::size_t i = 0; i < tags.size(); ++i) place[tags[i]] = i;
  std::vector<std::size_t> used = corners;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const std::size_t tag : used) {
    const double* at = &coordinates[3 * place.at(tag)];
    mesh.points.emplace_back(unit * at[0], unit * at[1], unit * at[2]);
  }
  const auto index_of = [&used](std::size_t tag) {
    return static_cast<Index>(std::lower_bound(used.begin(), used.end(), tag) - used.begin());
  };
  for (std::size_t i = 0; i < corners.size(); i += 3)
    mesh.triangles.push_back({index_of(corners[i]), index_of(corners[i + 1]), index_of(corners[i + 2])});
}

}  // namespace

GmshSession::GmshSession() {
  session_mutex().lock();
  constexpr bool read_config_files = false;  // a user's own settings would change the mesh
  gmsh::initialize(0, nullptr, read_config_files);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
}

GmshSession::~GmshSession() {
  gmsh::finalize();
  session_mutex().unlock();
}

SurfaceMesh take_triangles(const std::string& name, double unit) {
  SurfaceMesh mesh;
  std::vector<std::size_t> corners;
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  for (const auto& [dimension, surface] : surfaces) append_surface(name, surface, mesh, corners);
  if (corners.empty())
    throw InputError(name + ": there are no triangles",
                     "give a surface mesh; volumes and lines are not read");
  number_points(corners, unit, mesh);
  return mesh;
}

}  // namespace fiberfate
