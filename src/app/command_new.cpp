// Writes new case files.
#include "app/command_new.hpp"

#include "app/study_registry.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "app/gallery.hpp"
#include "base/error.hpp"
#include "keys/case_file.hpp"

namespace fiberfate {
namespace {

namespace fs = std::filesystem;

struct NewFile {
  std::string name;
  std::string text;
};

[[noreturn]] void refuse_name(const std::string& what) {
  std::vector<std::string> names = study_names();
  for (std::string& name : gallery_names()) names.push_back(std::move(name));
  const std::string nearest = nearest_word(what, names);
  throw InputError(fmt::format("'{}' is neither a study nor a case of the gallery", what),
                   nearest.empty() ? fmt::format("give one of {}", fmt::join(names, ", "))
                                   : fmt::format("did you mean '{}'?", nearest));
}

/// The files to write and the name of their folder.
std::pair<std::string, std::vector<NewFile>> files_of(const std::string& what) {
  if (const Study* study = find_study(what)) return {what, {{"case.toml", case_template(*study)}}};
  const std::string name = find_gallery_case(what);
  if (name.empty()) refuse_name(what);
  std::vector<NewFile> files;
  for (const GalleryFile& file : files_of_case(name))
    files.push_back({std::string(file.name), std::string(file.text)});
  return {name, files};
}

void refuse_existing(const fs::path& folder, const std::vector<NewFile>& files) {
  std::vector<InputProblem> problems;
  for (const NewFile& file : files)
    if (fs::exists(folder / file.name))
      problems.push_back({(folder / file.name).lexically_normal().string(), 0, 0, "", "", "exists already",
                          "give another folder, or --overwrite"});
  if (!problems.empty()) throw InputError(std::move(problems));
}

void write_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file)
    throw StorageError(
        fmt::format("{} cannot be written; check the folder and the space left", path.string()));
  if (text.starts_with("#!"))
    fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                    fs::perm_options::add);
}

}  // namespace

int run_new(const NewOptions& options) {
  const auto [name, files] = files_of(options.what);
  const fs::path folder = options.folder.empty() ? fs::path(name) : fs::path(options.folder);
  if (options.existing == NewOptions::Existing::refuse) refuse_existing(folder, files);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw StorageError(fmt::format("{} cannot be made ({})", folder.string(), error.message()));
  for (const NewFile& file : files) write_file(folder / file.name, file.text);
  const std::string case_file = (folder / "case.toml").lexically_normal().string();
  fmt::print("{}\n\nRun it with\n  fiberfate run {}\n", case_file, case_file);
  return 0;
}

}  // namespace fiberfate
