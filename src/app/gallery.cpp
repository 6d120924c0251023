// Finds cases of the gallery by name.
#include "app/gallery.hpp"

namespace fiberfate {

std::vector<std::string> gallery_names() {
  std::vector<std::string> names;
  for (const GalleryFile& file : gallery_files())
    if (names.empty() || names.back() != file.case_name) names.emplace_back(file.case_name);
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
