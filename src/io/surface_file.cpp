// Reads surfaces through Gmsh, after a look at what kind of file it is.
#include "io/surface_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "io/gmsh_session.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t stl_head = 84;      // bytes before the triangles of a binary STL file
constexpr std::size_t stl_triangle = 50;  // bytes of each

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

/// Reads the first bytes of a file.
std::string head_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be read", "check the path and the permission");
  std::string head(stl_head, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

bool is_stl(const std::string& path, const std::string& head) {
  if (head.starts_with("solid")) return true;
  if (head.size() < stl_head) return false;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, head.data() + stl_head - sizeof triangles, sizeof triangles);
  return std::filesystem::file_size(path) == stl_head + stl_triangle * triangles;
}

/// Gmsh takes what it does not know for a script and runs it, so that nothing doubtful may reach it.
void require_mesh_file(const std::string& path) {
  const std::string extension = lower_extension(path);
  const std::string head = head_of(path);
  if (extension == ".msh" && !head.starts_with("$MeshFormat"))
    throw InputError(path + ": is not a Gmsh mesh: it does not begin with $MeshFormat",
                     "save the mesh from Gmsh in format 2.2 or 4.1");
  if (extension == ".stl" && !is_stl(path, head))
    throw InputError(path + ": is not an STL file, or is cut short", "export the surface again");
  if (extension != ".msh" && extension != ".stl")
    throw InputError(path + ": is neither a .msh nor an .stl file",
                     "save the part as a Gmsh mesh or as STL, with that extension");
}

/// Lets Gmsh read a file that has been looked at.
void open_in(const GmshSession& session, const std::string& path) {
  try {
    session.library().call(session.library().open, path.c_str());
  } catch (const GmshError& error) {
    throw InputError(fmt::format("{}: Gmsh cannot read it: {}", path, error.what()), "save the mesh again");
  }
}

}  // namespace

SurfaceMesh read_surface(const std::string& path, double unit) {
  require_mesh_file(path);
  const GmshSession session;
  open_in(session, path);
  return take_triangles(session, path, unit);
}

ElementData read_element_data(const std::string& path, const std::string& name) {
  require_mesh_file(path);
  const GmshSession session;
  open_in(session, path);
  return take_element_data(session, path, name);
}

}  // namespace fiberfate
