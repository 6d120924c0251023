// Reads surfaces, after a look at what kind of file it is.
#include "io/surface_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "io/gmsh_process.hpp"
#include "io/input_file.hpp"
#include "io/stl_file.hpp"
#include "io/surface_orientation.hpp"

namespace fiberfate {
namespace {

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

/// Raises InputError with the first line of a file.
[[noreturn]] void refuse_head(const std::string& path, const std::string& complaint,
                              const std::string& remedy) {
  throw InputError({{path, 1, 1, "", "", complaint, remedy}});
}

/// Gmsh takes what it does not know for a script and runs it, so that nothing doubtful may reach it: a mesh
/// begins with $MeshFormat, or with comments before it.
void require_gmsh_mesh(const std::string& path) {
  require_readable(path);
  std::ifstream file(path, std::ios::binary);
  std::string line;
  const auto is = [&line](std::string_view word) { return line == word || line == std::string(word) + '\r'; };
  std::getline(file, line);
  if (is("$Comments")) {
    while (std::getline(file, line) && !is("$EndComments")) continue;
    std::getline(file, line);
  }
  if (!is("$MeshFormat"))
    refuse_head(path, "is not a Gmsh mesh: it does not begin with $MeshFormat",
                "save the mesh from Gmsh in format 2.2 or 4.1");
}

/// Lets Gmsh read a mesh file: within the time of a hundredfold of what a sound file takes.
GmshTask reading_of(const std::string& path) {
  constexpr double least = 5, seconds_per_byte = 1e-5;
  std::error_code ignored;
  const auto bytes = static_cast<double>(std::filesystem::file_size(path, ignored));
  return {path + ": Gmsh cannot read it", "it is damaged or of an unknown format: save the mesh again",
          least + seconds_per_byte * bytes};
}

void open_in(const GmshSession& session, const std::string& path) {
  session.library().call(session.library().open, path.c_str());
}

SurfaceMesh read_gmsh_mesh(const std::string& path, double unit) {
  require_gmsh_mesh(path);
  return surface_from_gmsh(reading_of(path), [&](const GmshSession& session) {
    open_in(session, path);
    return take_triangles(session, path, unit);
  });
}

void require_finite(const SurfaceMesh& mesh, const std::string& path) {
  const auto lost = std::find_if(mesh.points.begin(), mesh.points.end(),
                                 [](const Vec3& point) { return !point.allFinite(); });
  if (lost != mesh.points.end())
    throw InputError(
        {{path, 0, 0, "", "",
          fmt::format("point {} of {} is not finite", lost - mesh.points.begin() + 1, mesh.points.size()),
          "save the mesh again"}});
}

}  // namespace

SurfaceMesh read_surface(const std::string& path, double unit) {
  const std::string extension = lower_extension(path);
  if (extension != ".msh" && extension != ".stl") {
    require_readable(path);
    refuse_head(path, "is neither a .msh nor an .stl file",
                "save the part as a Gmsh mesh or as STL, with that extension");
  }
  SurfaceMesh mesh = extension == ".stl" ? read_stl(path, unit) : read_gmsh_mesh(path, unit);
  require_finite(mesh, path);
  if (const std::size_t turned = turn_to_agree(mesh); turned > 0)
    mesh.remarks.push_back(fmt::format("{} of {} triangles {} turned to agree with the others", turned,
                                       mesh.triangles.size(), turned == 1 ? "is" : "are"));
  return mesh;
}

ElementData read_element_data(const std::string& path, const std::string& name) {
  require_gmsh_mesh(path);
  return data_from_gmsh(reading_of(path), [&](const GmshSession& session) {
    open_in(session, path);
    return take_element_data(session, path, name);
  });
}

}  // namespace fiberfate
