// Finds cases of the gallery by name.
#include "app/gallery.hpp"

#include <algorithm>

namespace fiberfate {
namespace {

/// Whether a script of these files, or a module among them, imports a module of this name.
bool is_imported(const GalleryFile& module, const std::vector<GalleryFile>& files) {
  const std::string stem(module.name.substr(0, module.name.rfind('.')));
  return std::ranges::any_of(files, [&stem](const GalleryFile& file) {
    return file.name.ends_with(".py") && file.text.find("from " + stem + " import") != file.text.npos;
  });
}

}  // namespace

std::vector<GalleryFile> files_of_case(const std::string& name) {
  std::vector<GalleryFile> files;
  for (const GalleryFile& file : gallery_files())
    if (file.case_name == name) files.push_back(file);
  for (const GalleryFile& file : gallery_files())
    if (file.case_name.empty() && is_imported(file, files)) files.push_back(file);
  return files;
}

std::vector<std::string> gallery_names() {
  std::vector<std::string> names;
  for (const GalleryFile& file : gallery_files())
    if (!file.case_name.empty() && (names.empty() || names.back() != file.case_name))
      names.emplace_back(file.case_name);
  return names;
}

std::string find_gallery_case(const std::string& wanted) {
  for (const std::string& name : gallery_names()) {
    const auto underscore = name.find('_');
    if (wanted == name || wanted == name.substr(0, underscore) || wanted == name.substr(underscore + 1))
      return name;
  }
  return "";
}

}  // namespace fiberfate
