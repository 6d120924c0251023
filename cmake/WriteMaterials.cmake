# Writes OUTPUT, a source that holds the files of MATERIALS as raw strings.
file(GLOB materials RELATIVE "${MATERIALS}" "${MATERIALS}/*.toml")
list(SORT materials)
set(presets "")
foreach(file IN LISTS materials)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${MATERIALS}/${file}" text)
  string(APPEND presets "    {\"${name}\", R\"material(${text})material\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from materials/ by cmake/WriteMaterials.cmake.
#include <array>

#include \"keys/material_presets.hpp\"

namespace fiberfate {
namespace {

constexpr auto presets = std::to_array<MaterialPreset>({
${presets}});

}  // namespace

std::span<const MaterialPreset> material_presets() { return presets; }

}  // namespace fiberfate
")
