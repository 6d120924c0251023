// Gmsh at work in a process of its own, for it may crash on damaged files and impossible sizes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "io/gmsh_session.hpp"

namespace fiberfate {

/// What Gmsh is asked to do, for messages, and what it may use.
struct GmshTask {
  std::string complaint;  ///< "part.msh: Gmsh cannot read it"
  std::string remedy;
  double processor_seconds;
};

/// Makes surfaces with a session of Gmsh in a child process. Raises InputError when Gmsh refuses or crashes.
[[nodiscard]] SurfaceMesh surface_from_gmsh(const GmshTask& task,
                                            const std::function<SurfaceMesh(const GmshSession&)>& make);
/// Makes element data likewise.
[[nodiscard]] ElementData data_from_gmsh(const GmshTask& task,
                                         const std::function<ElementData(const GmshSession&)>& make);

}  // namespace fiberfate
