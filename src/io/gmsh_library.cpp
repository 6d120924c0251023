// Finds Gmsh's functions in its shared library.
#include "io/gmsh_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/memory.hpp"

namespace fiberfate {
namespace {

/// Address space that the library and those that it loads take; with less they crash as they begin.
constexpr double library_bytes = 150e6;

void* open_library() {
  require_memory(library_bytes,
                 "allow more (ulimit -v): that is Gmsh's library, which meshes and reads parts");
  // The version that this program was built with, else any.
  for (const char* name : {FIBERFATE_GMSH_LIBRARY, "libgmsh.so"})
    if (void* handle = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return handle;
  throw InputError(fmt::format("parts cannot be meshed or read: {}", dlerror()),
                   "install Gmsh's library (Debian: apt-get install libgmsh4.8)");
}

template <class Function>
void bind(void* handle, Function& function, const char* name) {
  void* symbol = dlsym(handle, name);
  if (symbol == nullptr)
    throw InputError(fmt::format("the Gmsh library has no {}", name), "install Gmsh 4.8 or later");
  function = reinterpret_cast<Function>(symbol);
}

GmshLibrary load() {
  void* handle = open_library();
  GmshLibrary library{};
  bind(handle, library.initialize, "gmshInitialize");
  bind(handle, library.finalize, "gmshFinalize");
  bind(handle, library.free, "gmshFree");
  bind(handle, library.last_error, "gmshLoggerGetLastError");
  bind(handle, library.set_option, "gmshOptionSetNumber");
  bind(handle, library.open, "gmshOpen");
  bind(handle, library.text_option, "gmshOptionGetString");
  bind(handle, library.views, "gmshViewGetTags");
  bind(handle, library.view_index, "gmshViewGetIndex");
  bind(handle, library.view_data, "gmshViewGetHomogeneousModelData");
  bind(handle, library.add_model, "gmshModelAdd");
  bind(handle, library.entities, "gmshModelGetEntities");
  bind(handle, library.groups_of, "gmshModelGetPhysicalGroupsForEntity");
  bind(handle, library.group_name, "gmshModelGetPhysicalName");
  bind(handle, library.name_group, "gmshModelSetPhysicalName");
  bind(handle, library.add_group, "gmshModelAddPhysicalGroup");
  bind(handle, library.element_types, "gmshModelMeshGetElementTypes");
  bind(handle, library.elements, "gmshModelMeshGetElementsByType");
  bind(handle, library.nodes, "gmshModelMeshGetNodes");
  bind(handle, library.embed, "gmshModelMeshEmbed");
  bind(handle, library.generate, "gmshModelMeshGenerate");
  bind(handle, library.add_point, "gmshModelGeoAddPoint");
  bind(handle, library.add_line, "gmshModelGeoAddLine");
  bind(handle, library.add_loop, "gmshModelGeoAddCurveLoop");
  bind(handle, library.add_surface, "gmshModelGeoAddPlaneSurface");
  bind(handle, library.synchronize, "gmshModelGeoSynchronize");
  return library;
}

}  // namespace

void GmshLibrary::check(int error) const {
  if (error == 0) return;
  char* text = nullptr;
  int ignored = 0;
  last_error(&text, &ignored);
  const std::string reason = text == nullptr ? "no reason given" : text;
  free(text);
  throw GmshError(reason);
}

const GmshLibrary& gmsh_library() {
  static const GmshLibrary library = load();
  return library;
}

}  // namespace fiberfate
