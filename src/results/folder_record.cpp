// The record of a result folder.
#include "results/folder_record.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <sstream>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace fiberfate {
namespace {

constexpr const char* heading =
    "# Files that fiberfate made here, and the process that last wrote to them.\n";

struct RecordText {
  std::set<std::string> files;
  std::optional<std::uint64_t> case_digest;
  std::string holder;  ///< of the last "run" line
  bool ended = false;  ///< "end" came after it
};

RecordText parse(const std::string& text) {
  RecordText parsed;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line == "end") parsed.ended = true;
    const std::size_t space = line.find(' ');
    if (space == std::string::npos) continue;
    const std::string word = line.substr(0, space), rest = line.substr(space + 1);
    // A name that leads out of the folder is none that the program writes.
    if (word == "file" && rest.find('/') == std::string::npos && rest != "." && rest != "..")
      parsed.files.insert(rest);
    if (word == "run") {
      parsed.holder = rest;
      parsed.ended = false;
    }
    std::uint64_t number = 0;
    if (word == "case" &&
        std::from_chars(rest.data(), rest.data() + rest.size(), number, 16).ec == std::errc())
      parsed.case_digest = number;
  }
  return parsed;
}

std::string this_host() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return host.data();
}

std::string this_process() {
  return fmt::format("{} {} {:%Y-%m-%dT%H:%M:%S}", ::getpid(), this_host(),
                     fmt::localtime(std::time(nullptr)));
}

/// Whether a path still names the file that was opened; a process that gives up its folder removes its
/// record.
bool is_at(const std::string& path, int descriptor) {
  struct stat there {
  }, opened{};
  return ::stat(path.c_str(), &there) == 0 && ::fstat(descriptor, &opened) == 0 &&
         there.st_ino == opened.st_ino && there.st_dev == opened.st_dev;
}

/// Whether the process that a record names, "PROCESS HOST TIME", has ended on this machine.
bool has_ended(const std::string& holder) {
  std::istringstream words(holder);
  pid_t process = 0;
  std::string host;
  return words >> process >> host && host == this_host() && ::kill(process, 0) != 0 && errno == ESRCH;
}

/// Who holds a record; nothing where its holder has just given it up. One that has just locked it may not
/// have written its name over that of the one before.
std::string holder_of(const std::string& path) {
  constexpr int most_looks = 100;
  for (int look = 0; look < most_looks; ++look) {
    try {
      if (std::string holder = parse(read_file(path)).holder; !has_ended(holder)) return holder;
    } catch (const StorageError&) {
      return {};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return {};
}

[[noreturn]] void refuse_held(const std::string& folder, const std::string& holder) {
  std::istringstream words(holder);
  std::string process, host, time;
  words >> process >> host >> time;
  throw InputError(process.empty() ? folder + " is being written to by another process"
                                   : fmt::format("{} is being written to by process {} on {}, since {}",
                                                 folder, process, host, time),
                   "wait for it to end or stop it, or name another folder with --out");
}

}  // namespace

std::set<std::string> recorded_files(const std::string& folder) {
  const std::string path = folder + '/' + folder_record_name;
  return std::filesystem::exists(path) ? parse(read_file(path)).files : std::set<std::string>{};
}

void refuse_unrecorded(const std::string& path) {
  throw InputError(path + " is there already, and no record in its folder says that fiberfate made it",
                   "name another folder with --out, or move that file away");
}

void record_file(const std::string& folder, const std::string& name) {
  AppendedFile record(folder + '/' + folder_record_name);
  record.append(fmt::format("file {}\n", name));
  record.flush();
}

FolderRecord::FolderRecord(const std::string& folder) : path_(folder + '/' + folder_record_name) {
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    lock(folder);
  } while (!is_at(path_, descriptor_));
  const std::string text = read_file(path_);
  is_new_ = text.empty();
  const RecordText known = parse(text);
  files_ = known.files;
  case_digest_ = known.case_digest;
  was_ended_ = known.ended;
  if (is_new_) append(heading);
  append(fmt::format("run {}\n", this_process()));
}

void FolderRecord::lock(const std::string& folder) {
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (descriptor_ < 0) throw storage_error("cannot create", path_);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const bool held = errno == EWOULDBLOCK;
  const StorageError failure = storage_error("cannot lock", path_);
  ::close(descriptor_);
  if (held) refuse_held(folder, holder_of(path_));
  throw failure;
}

FolderRecord::FolderRecord(FolderRecord&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      files_(std::move(other.files_)),
      case_digest_(other.case_digest_),
      is_new_(other.is_new_),
      was_ended_(other.was_ended_) {}

FolderRecord::~FolderRecord() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void FolderRecord::append(const std::string& line) {
  const auto size = static_cast<ssize_t>(line.size());
  if (::write(descriptor_, line.data(), line.size()) != size) throw storage_error("cannot write", path_);
}

void FolderRecord::add_file(const std::string& name) {
  if (files_.contains(name)) return;
  append(fmt::format("file {}\n", name));
  files_.insert(name);
}

void FolderRecord::set_case(std::uint64_t digest) {
  append(fmt::format("case {:016x}\n", digest));
  case_digest_ = digest;
}

void FolderRecord::end() {
  append("end\n");
}

void FolderRecord::clear() {
  if (::ftruncate(descriptor_, 0) != 0) throw storage_error("cannot write", path_);
  files_.clear();
  case_digest_.reset();
  append(heading);
  append(fmt::format("run {}\n", this_process()));
}

void FolderRecord::restore(const std::string& text) noexcept {
  if (::ftruncate(descriptor_, 0) != 0) return;
  [[maybe_unused]] const ssize_t written = ::write(descriptor_, text.data(), text.size());
}

}  // namespace fiberfate
