# Writes OUTPUT, a source that holds the files below CASES as strings: those of the cases, and the modules that their
# scripts share.
file(GLOB files RELATIVE "${CASES}" "${CASES}/*.py" "${CASES}/[0-9][0-9]_*/*")
list(SORT files)
set(entries "")
foreach(file IN LISTS files)
  get_filename_component(case_name "${file}" DIRECTORY)
  get_filename_component(name "${file}" NAME)
  # Compilers turn the line breaks of CSV files in raw strings into others.
  if(name MATCHES "\\.(png|svg|csv)$")
    file(READ "${CASES}/${file}" text HEX)
    string(REGEX REPLACE "(..)" "\\\\x\\1" text "${text}")
    set(text "\"${text}\"sv")
  else()
    file(READ "${CASES}/${file}" text)
    # A copy stands by itself: what lies beside the gallery is named, not linked.
    if(name MATCHES "\\.md$")
      string(REGEX REPLACE "\\[([^]\n]*)\\]\\(\\.\\./[^)\n]*\\)" "\\1" text "${text}")
    endif()
    set(text "R\"gallery(${text})gallery\"sv")
  endif()
  string(APPEND entries "    {\"${case_name}\", \"${name}\", ${text}},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from cases/ by cmake/WriteGallery.cmake.
#include <array>

#include \"app/gallery.hpp\"

namespace fiberfate {
namespace {

using namespace std::string_view_literals;

constexpr auto files = std::to_array<GalleryFile>({
${entries}});

}  // namespace

std::span<const GalleryFile> gallery_files() { return files; }

}  // namespace fiberfate
")
