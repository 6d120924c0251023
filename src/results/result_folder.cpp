// Makes, opens and clears result folders.
#include "results/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/error.hpp"

namespace fiberfate {
namespace {

namespace fs = std::filesystem;

// What a run, or a report about it, writes and what a result is known by; the leftovers of a killed run too.
constexpr std::array result_files = {
    "case.resolved.toml",
    "summary.json",
    "series.csv",
    "breaks.csv",
    "result.vtkhdf",
    "result.vtkhdf.next",
    "result.vtkhdf.kept",
    "checkpoint.h5",
    "checkpoint.h5.new",
    "checkpoint.previous.h5",
    "failure.h5",
    "failure.h5.new",
    "log.txt",
    "report.html",
};

// Tables that some studies add; alone they are no result.
constexpr std::array study_tables = {
    "histogram.csv",     "histogram_compared.csv",
    "distribution.csv",  "directions.csv",
    "modulus.csv",       "fit.csv",
    "curves.csv",        "profile.csv",
    "bootstrap.csv",     "sweep.csv",
    "places.csv",        "profiles.csv",
    "layers.vtkhdf",     "layers.vtkhdf.new",
    "properties.vtkhdf", "properties.vtkhdf.next",
};

std::string without_slash(std::string path) {
  while (path.size() > 1 && path.ends_with('/')) path.pop_back();
  return path;
}

}  // namespace

bool ResultFolder::holds_result() const {
  return std::any_of(result_files.begin(), result_files.end(),
                     [this](const char* name) { return fs::exists(file(name)); });
}

void ResultFolder::remove() const {
  for (const char* name : result_files) fs::remove(file(name));
  for (const char* name : study_tables) fs::remove(file(name));
  if (fs::is_empty(path_)) fs::remove(path_);
}

ResultFolder ResultFolder::create(const std::string& path, Existing existing) {
  ResultFolder folder(without_slash(path));
  if (fs::exists(folder.path_) && !fs::is_directory(folder.path_))
    throw InputError(folder.path_ + " is a file", "name a folder with --out");
  if (folder.holds_result()) {
    if (existing == Existing::refuse)
      throw InputError(
          folder.path_ + " already holds a result",
          "name another folder with --out, continue that run with 'fiberfate resume', or replace it "
          "with --overwrite");
    folder.remove();
  }
  std::error_code reason;
  fs::create_directories(folder.path_, reason);
  if (reason)
    throw InputError(fmt::format("cannot make the folder {}: {}", folder.path_, reason.message()),
                     "name another folder with --out");
  return folder;
}

ResultFolder ResultFolder::open(const std::string& path) {
  ResultFolder folder(without_slash(path));
  if (!fs::is_directory(folder.path_))
    throw InputError(folder.path_ + " is not a folder", "name the folder of a result");
  if (!fs::exists(folder.resolved_case()))
    throw InputError(folder.path_ + " holds no result: case.resolved.toml is missing",
                     "name the folder that 'fiberfate run' wrote");
  return folder;
}

}  // namespace fiberfate
