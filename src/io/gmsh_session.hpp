// Owns a session of the Gmsh library and takes triangles out of it; only sources of io include it.
#pragma once

#include <string>

#include "io/gmsh_library.hpp"
#include "io/surface_file.hpp"

namespace fiberfate {

/// Starts Gmsh silent, without display and on one thread; ends it with its scope. Gmsh keeps everything in
/// global variables and changes the threads of parallel loops: a process has one session, in a child of its
/// own (gmsh_process.hpp).
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;
  [[nodiscard]] const GmshLibrary& library() const { return library_; }

 private:
  const GmshLibrary& library_;
};

/// Takes the triangles of all surfaces; `unit` scales the points. Raises InputError, which calls the source
/// `name`, when there are none or when a surface holds other elements.
[[nodiscard]] SurfaceMesh take_triangles(const GmshSession& session, const std::string& name, double unit);

/// Takes the data `view` that belong to elements, one number each. Raises InputError, which calls the source
/// `name`, when there are none of that name or they are of another kind.
[[nodiscard]] ElementData take_element_data(const GmshSession& session, const std::string& name,
                                            const std::string& view);

}  // namespace fiberfate
