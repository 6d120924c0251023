// Writes whole files through the operating system's own calls, whose errors name the reason.
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "io/disk_faults.hpp"

namespace fiberfate {
namespace {

constexpr mode_t permissions = 0666;  // the user's umask takes away what it must

/// Owns a file descriptor.
class Descriptor {
 public:
  Descriptor(const std::string& path, int flags)
      : number_(::open(path.c_str(), flags | O_CLOEXEC, permissions)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// Writes everything; tells whether it could.
bool write_all(int descriptor, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(descriptor, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = ENOSPC;
    if (written <= 0) return false;
    bytes += written;
    count -= written;
  }
  return true;
}

void sync_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const Descriptor descriptor(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
  // A file system that cannot sync a folder still has the file itself; the rename just lasts a little later.
  if (descriptor.number() >= 0) ::fsync(descriptor.number());
}

}  // namespace

StorageError storage_error(std::string_view action, const std::string& path) {
  return StorageError(fmt::format("{} {}: {}", action, path, reason_text(errno)));
}

void replace_file(const std::string& path, std::string_view text) {
  const std::string fresh = path + ".new";
  try {
    const Descriptor file(fresh, O_WRONLY | O_CREAT | O_TRUNC);
    if (file.number() < 0) throw storage_error("cannot create", fresh);
    if (!write_all(file.number(), text.data(), text.size())) throw storage_error("cannot write", path);
    if (::fsync(file.number()) != 0) throw storage_error("cannot write", path);
    rename_file(fresh, path);
  } catch (...) {
    ::unlink(fresh.c_str());
    throw;
  }
}

std::string read_file(const std::string& path) {
  const Descriptor file(path, O_RDONLY | O_NONBLOCK);  // opening a pipe would wait for a writer
  if (file.number() < 0) throw storage_error("cannot open", path);
  struct stat status {};
  if (::fstat(file.number(), &status) == 0 && !S_ISREG(status.st_mode))
    throw StorageError(fmt::format("cannot read {}: it is not a file", path));
  std::string text;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t count = ::read(file.number(), buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw storage_error("cannot read", path);
    if (count == 0) return text;
    text.append(buffer, count);
  }
}

void sync_file(const std::string& path) {
  const Descriptor file(path, O_RDONLY);
  if (file.number() < 0) throw storage_error("cannot open", path);
  if (::fsync(file.number()) != 0) throw storage_error("cannot write", path);
}

void rename_file(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) throw storage_error("cannot rename to", to);
  sync_folder_of(to);
}

void copy_file(const std::string& from, const std::string& to) {
  std::error_code reason;
  std::filesystem::copy_file(from, to, reason);
  if (reason) throw StorageError(fmt::format("cannot write {}: {}", to, reason_text(reason.value())));
}

void cut_file(const std::string& path, std::size_t bytes) {
  if (::truncate(path.c_str(), static_cast<off_t>(bytes)) != 0) throw storage_error("cannot cut", path);
}

void exchange_files(const std::string& first, const std::string& second) {
  // A second name keeps the first file alive while the other one takes its place: renaming alone, in two
  // steps, would leave a moment without it.
  const std::string kept = first + ".kept";
  ::unlink(kept.c_str());
  if (::link(first.c_str(), kept.c_str()) != 0) throw storage_error("cannot link", kept);
  rename_file(second, first);
  rename_file(kept, second);
}

AppendedFile::AppendedFile(std::string path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, permissions);
  if (descriptor_ < 0) throw storage_error("cannot open", path_);
}

AppendedFile::~AppendedFile() {
  // What could not be written has been reported by flush(); there is nobody left to tell here.
  static_cast<void>(write_all(descriptor_, waiting_.data(), waiting_.size()));
  ::close(descriptor_);
}

void AppendedFile::flush() {
  const std::string text = std::exchange(waiting_, {});
  if (!write_all(descriptor_, text.data(), text.size())) throw storage_error("cannot write", path_);
}

void AppendedFile::sync() {
  flush();
  if (::fsync(descriptor_) != 0) throw storage_error("cannot write", path_);
}

}  // namespace fiberfate
