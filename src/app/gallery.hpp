// The gallery of cases, which is built into the program so that it is there wherever that is installed.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fiberfate {

/// One file of the gallery.
struct GalleryFile {
  std::string_view case_name;  ///< "01_jeffery_orbit"; empty for a module that scripts of cases share
  std::string_view name;       ///< "case.toml"
  std::string_view text;
};

/// All files: shared modules, then case by case.
[[nodiscard]] std::span<const GalleryFile> gallery_files();

/// The files of a case, and the shared modules that its scripts import.
[[nodiscard]] std::vector<GalleryFile> files_of_case(const std::string& name);

/// Lists the names of the cases, in their order.
[[nodiscard]] std::vector<std::string> gallery_names();

/// Finds a case by its name, with or without its number, or by its number; empty when there is none.
[[nodiscard]] std::string find_gallery_case(const std::string& wanted);

}  // namespace fiberfate
