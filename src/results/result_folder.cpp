// Makes, opens and gives back result folders.
#include "results/result_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "base/digest.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace fiberfate {
namespace {

namespace fs = std::filesystem;

/// Every file that some run leaves; a folder where one of them is a user's own is not written to.
constexpr std::array names_of_results = {
    "case.resolved.toml", "summary.json",   "series.csv",  "breaks.csv",    "result.vtkhdf",
    "checkpoint.h5",      "log.txt",        "report.html", "failure.h5",    "checkpoint.previous.h5",
    "histogram.csv",      "modulus.csv",    "curves.csv",  "bootstrap.csv", "histogram_compared.csv",
    "distribution.csv",   "directions.csv", "fit.csv",     "profile.csv",   "sweep.csv",
    "places.csv",         "profiles.csv",   "optimum.csv", "layers.vtkhdf", "properties.vtkhdf",
    "density.csv",
};
/// What writers add to the name of a file for a moment.
constexpr std::array moment_suffixes = {"", ".new", ".next", ".kept"};

// Where the files of a result wait while another one takes its place, and where they are while they move
// there.
constexpr const char* replaced_folder = ".fiberfate-replaced";
constexpr const char* moving_folder = ".fiberfate-moving";

std::string without_slash(std::string path) {
  while (path.size() > 1 && path.ends_with('/')) path.pop_back();
  return path;
}

bool exists(const std::string& path) {
  return fs::exists(fs::symlink_status(path));
}

void require_folder(const std::string& path) {
  std::error_code reason;
  const fs::file_status status = fs::status(path, reason);
  if (status.type() == fs::file_type::none)
    throw InputError(fmt::format("cannot reach {}: {}", path, reason.message()),
                     "name another folder with --out");
  if (fs::exists(status) && !fs::is_directory(status))
    throw InputError(path + " is a file", "name a folder with --out");
}

/// Makes a folder and its parents and lists those that were not there, the outermost first.
std::vector<std::string> make_folders(const std::string& path) {
  std::vector<std::string> made;
  for (fs::path one = path; !one.empty() && !exists(one.string()); one = one.parent_path())
    made.insert(made.begin(), one.string());
  std::error_code reason;
  fs::create_directories(path, reason);
  if (reason)
    throw InputError(fmt::format("cannot make the folder {}: {}", path, reason.message()),
                     "name another folder with --out");
  return made;
}

/// Moves all that waits in a folder of the result back to its place.
void move_back(const ResultFolder& folder, const char* waiting) noexcept {
  std::error_code ignored;  // what cannot be moved stays where it is
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder.file(waiting), ignored))
    entries.push_back(entry.path());
  for (const fs::path& entry : entries) fs::rename(entry, folder.file(entry.filename().string()), ignored);
  fs::remove(folder.file(waiting), ignored);
}

/// Finds a file that a run may write and that the program did not make; empty when there is none.
std::string file_of_a_user(const ResultFolder& folder, const std::set<std::string>& known) {
  for (const char* name : names_of_results)
    if (!known.contains(name) && exists(folder.file(name))) return name;
  return {};
}

bool holds_any(const ResultFolder& folder, const std::set<std::string>& known) {
  return std::any_of(known.begin(), known.end(),
                     [&](const std::string& name) { return exists(folder.file(name)); });
}

/// Raises InputError where a new run may not write to a folder in which the program made the known files.
void require_room(const ResultFolder& folder, const std::set<std::string>& known, Existing existing) {
  const std::string foreign = file_of_a_user(folder, known);
  if (existing == Existing::refuse && (holds_any(folder, known) || exists(folder.resolved_case())))
    throw InputError(
        folder.path() + " already holds a result",
        "name another folder with --out, continue that run with 'fiberfate resume', or replace it "
        "with --overwrite");
  if (!foreign.empty()) refuse_unrecorded(folder.file(foreign));
}

/// Raises InputError where a folder holds no result.
void require_result(const ResultFolder& folder) {
  std::error_code reason;
  if (!fs::is_directory(folder.path(), reason))
    throw InputError(folder.path() + " is not a folder", "name the folder of a result");
  if (fs::exists(folder.resolved_case(), reason)) return;
  if (reason)
    throw InputError(fmt::format("cannot reach {}: {}", folder.resolved_case(), reason.message()),
                     "ask for the permission to read the folder");
  throw InputError(folder.path() + " holds no result: case.resolved.toml is missing",
                   "name the folder that 'fiberfate run' wrote");
}

/// Whether a process was killed here while it moved a result out of the way.
bool holds_moved_result(const ResultFolder& folder) {
  return exists(folder.file(moving_folder)) || exists(folder.file(replaced_folder));
}

}  // namespace

ResultFolder ResultFolder::open(const std::string& path) {
  ResultFolder folder(without_slash(path));
  require_result(folder);
  return folder;
}

OwnedFolder::OwnedFolder(ResultFolder folder, std::vector<std::string> made_folders)
    : folder_(std::move(folder)), made_folders_(std::move(made_folders)) {}

OwnedFolder::OwnedFolder(OwnedFolder&& other) noexcept
    : folder_(std::move(other.folder_)),
      made_folders_(std::move(other.made_folders_)),
      record_(std::move(other.record_)),
      earlier_record_(std::move(other.earlier_record_)),
      stands_(std::exchange(other.stands_, true)) {}

OwnedFolder::~OwnedFolder() {
  if (!stands_) undo();
}

OwnedFolder OwnedFolder::create(const std::string& path, Existing existing) {
  const ResultFolder folder(without_slash(path));
  require_folder(folder.path());
  require_room(folder, recorded_files(folder.path()), existing);
  OwnedFolder owned(folder, make_folders(folder.path()));
  owned.record_.emplace(folder.path());
  owned.stands_ = true;  // nothing here is this run's own yet
  owned.recover();
  // Another process may have come and gone since the first look.
  require_room(folder, owned.record_->files(), existing);
  if (holds_any(folder, owned.record_->files())) owned.put_aside();
  owned.stands_ = false;
  return owned;
}

OwnedFolder OwnedFolder::take(const std::string& path) {
  const ResultFolder folder(without_slash(path));
  if (!holds_moved_result(folder)) require_result(folder);
  OwnedFolder owned(folder, {});
  owned.stands_ = true;
  owned.record_.emplace(folder.path());
  owned.recover();
  require_result(folder);
  const auto begun_with = owned.record_->case_digest();
  if (begun_with && *begun_with != digest_of(read_file(owned.folder_.resolved_case())))
    throw InputError(owned.folder_.resolved_case() + " was changed after the run began",
                     "undo the change; to go on with other values, run a case of your own that starts from "
                     "this state (cluster.file = \"checkpoint.h5\")");
  // What an earlier version left is known by its names.
  if (owned.record_->files().empty())
    for (const char* name : names_of_results)
      if (exists(owned.folder_.file(name))) owned.record_->add_file(name);
  return owned;
}

/// Undoes what a process that was killed had begun: a result that it was moving away comes back, and one that
/// it had moved away before it wrote its own case.
void OwnedFolder::recover() {
  take_back(moving_folder);
  if (!exists(folder_.resolved_case())) take_back(replaced_folder);
}

void OwnedFolder::take_back(const char* waiting) {
  if (!exists(folder_.file(waiting))) return;
  for (const auto& entry : fs::directory_iterator(folder_.file(waiting)))
    if (entry.path().filename() != replaced_folder) record_->add_file(entry.path().filename().string());
  move_back(folder_, waiting);
}

void OwnedFolder::put_aside() {
  earlier_record_ = read_file(folder_.file(folder_record_name));
  std::set<std::string> names = record_->files();
  names.insert(replaced_folder);  // of a run that was killed while it replaced a result
  fs::create_directories(folder_.file(moving_folder));
  for (const std::string& name : names)
    if (exists(folder_.file(name)))
      rename_file(folder_.file(name), folder_.file(moving_folder + ('/' + name)));
  rename_file(folder_.file(moving_folder), folder_.file(replaced_folder));
  record_->clear();
}

std::string OwnedFolder::make(const std::string& name) {
  if (!record_->files().contains(name) && exists(folder_.file(name)))
    throw StorageError(folder_.file(name) + " appeared while the run went on, and fiberfate did not make it");
  record_->add_file(name);
  return folder_.file(name);
}

void OwnedFolder::write_case(const std::string& text) {
  replace_file(make("case.resolved.toml"), text);
  record_->set_case(digest_of(text));
}

void OwnedFolder::keep() {
  stands_ = true;
  std::error_code ignored;  // a file that cannot be removed harms nobody where it is
  fs::remove_all(folder_.file(replaced_folder), ignored);
}

std::string OwnedFolder::set_aside() {
  if (!replaces()) {
    keep();
    return folder_.path();
  }
  std::string aside = folder_.path() + ".failed";
  for (int number = 2; exists(aside); ++number) aside = fmt::format("{}.failed-{}", folder_.path(), number);
  fs::create_directories(aside);
  for (const std::string& name : record_->files())
    if (exists(folder_.file(name))) rename_file(folder_.file(name), aside + '/' + name);
  replace_file(aside + '/' + folder_record_name, read_file(folder_.file(folder_record_name)));
  undo();
  stands_ = true;
  return aside;
}

void OwnedFolder::undo() noexcept {
  if (!record_) return;
  std::error_code ignored;  // the first error is the one to report
  for (const std::string& name : record_->files())
    for (const char* suffix : moment_suffixes) fs::remove(folder_.file(name + suffix), ignored);
  if (replaces()) {
    move_back(folder_, replaced_folder);
    record_->restore(earlier_record_);
  } else {
    fs::remove(folder_.file(folder_record_name), ignored);
  }
  record_.reset();
  for (auto folder = made_folders_.rbegin(); folder != made_folders_.rend(); ++folder)
    if (fs::is_empty(*folder, ignored)) fs::remove(*folder, ignored);
}

}  // namespace fiberfate
