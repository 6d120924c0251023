# Writes OUTPUT, a source that holds the files below CASES and MATERIALS as raw strings.
file(GLOB_RECURSE files RELATIVE "${CASES}" "${CASES}/*.toml" "${CASES}/*.md" "${CASES}/*.txt" "${CASES}/*.csv"
     "${CASES}/*.msh")
list(SORT files)
set(entries "")
foreach(file IN LISTS files)
  get_filename_component(case_name "${file}" DIRECTORY)
  get_filename_component(name "${file}" NAME)
  if(case_name MATCHES "^[0-9][0-9]_[a-z0-9_]+$")
    file(READ "${CASES}/${file}" text)
    string(APPEND entries "    {\"${case_name}\", \"${name}\", R\"gallery(${text})gallery\"},\n")
  endif()
endforeach()
file(GLOB materials RELATIVE "${MATERIALS}" "${MATERIALS}/*.toml")
list(SORT materials)
set(presets "")
foreach(file IN LISTS materials)
  get_filename_component(name "${file}" NAME_WE)
  file(READ "${MATERIALS}/${file}" text)
  string(APPEND presets "    {\"${name}\", R\"material(${text})material\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from cases/ and materials/ by cmake/WriteGallery.cmake.
#include <array>

#include \"app/gallery.hpp\"
#include \"app/material_presets.hpp\"

namespace fiberfate {
namespace {

constexpr auto files = std::to_array<GalleryFile>({
${entries}});

constexpr auto presets = std::to_array<MaterialPreset>({
${presets}});

}  // namespace

std::span<const GalleryFile> gallery_files() { return files; }
std::span<const MaterialPreset> material_presets() { return presets; }

}  // namespace fiberfate
")
