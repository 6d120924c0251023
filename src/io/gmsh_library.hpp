// Loads the Gmsh library when it is first needed; only sources of io include it.
//
// Gmsh brings some ninety other libraries. A program that were linked to it would take twenty times as long
// to start, and most of its runs mesh nothing.
#pragma once

#include <gmshc.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace fiberfate {

/// Reports that Gmsh refused a call; `what` is its reason.
class GmshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The functions of Gmsh's C interface that io uses, named as in gmshc.h.
struct GmshLibrary {
  decltype(&gmshInitialize) initialize;
  decltype(&gmshFinalize) finalize;
  decltype(&gmshFree) free;
  decltype(&gmshLoggerGetLastError) last_error;
  decltype(&gmshOptionSetNumber) set_option;
  decltype(&gmshOpen) open;
  decltype(&gmshOptionGetString) text_option;
  decltype(&gmshViewGetTags) views;
  decltype(&gmshViewGetIndex) view_index;
  decltype(&gmshViewGetHomogeneousModelData) view_data;
  decltype(&gmshModelAdd) add_model;
  decltype(&gmshModelGetEntities) entities;
  decltype(&gmshModelGetPhysicalGroupsForEntity) groups_of;
  decltype(&gmshModelGetPhysicalName) group_name;
  decltype(&gmshModelSetPhysicalName) name_group;
  decltype(&gmshModelAddPhysicalGroup) add_group;
  decltype(&gmshModelMeshGetElementTypes) element_types;
  decltype(&gmshModelMeshGetElementsByType) elements;
  decltype(&gmshModelMeshGetNodes) nodes;
  decltype(&gmshModelMeshEmbed) embed;
  decltype(&gmshModelMeshGenerate) generate;
  decltype(&gmshModelGeoAddPoint) add_point;
  decltype(&gmshModelGeoAddLine) add_line;
  decltype(&gmshModelGeoAddCurveLoop) add_loop;
  decltype(&gmshModelGeoAddPlaneSurface) add_surface;
  decltype(&gmshModelGeoSynchronize) synchronize;

  /// Calls a function and hands its error code to check(); raises GmshError.
  template <class Function, class... Arguments>
  auto call(Function function, Arguments... arguments) const {
    int error = 0;
    if constexpr (std::is_void_v<decltype(function(arguments..., &error))>) {
      function(arguments..., &error);
      check(error);
    } else {
      const auto result = function(arguments..., &error);
      check(error);
      return result;
    }
  }
  void check(int error) const;
};

/// Gives the library; raises InputError when it is not installed.
[[nodiscard]] const GmshLibrary& gmsh_library();

/// Receives a list that Gmsh allocates: hand over `&list.items, &list.count`.
template <class T>
struct GmshList {
  explicit GmshList(const GmshLibrary& owner) : library(owner) {}
  ~GmshList() { library.free(items); }
  GmshList(const GmshList&) = delete;
  GmshList& operator=(const GmshList&) = delete;
  [[nodiscard]] std::vector<T> values() const { return {items, items + count}; }

  const GmshLibrary& library;
  T* items = nullptr;
  std::size_t count = 0;
};

}  // namespace fiberfate
