# Writes OUTPUT, a source that holds the files below CASES as raw strings.
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
file(WRITE "${OUTPUT}" "// Generated from cases/ by cmake/WriteGallery.cmake.
#include <array>

#include \"app/gallery.hpp\"

namespace fiberfate {
namespace {

constexpr auto files = std::to_array<GalleryFile>({
${entries}});

}  // namespace

std::span<const GalleryFile> gallery_files() { return files; }

}  // namespace fiberfate
")
