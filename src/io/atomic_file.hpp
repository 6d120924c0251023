// Writes files so that a reader, a crash or a full disk never meets half of one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace fiberfate {

/// Makes the error of a failed system call: "cannot write DIR/x: No space left on device" (reads errno).
[[nodiscard]] StorageError storage_error(std::string_view action, const std::string& path);

/// Replaces a file: the text goes to a new file in the same folder, which is synced and then renamed. At any
/// moment the path holds the old content or the new one, whole. Raises StorageError; the old content then
/// stays and the new file is removed.
void replace_file(const std::string& path, std::string_view text);

/// Reads a whole file; raises StorageError.
[[nodiscard]] std::string read_file(const std::string& path);

/// Waits until a file's content has reached the disk; raises StorageError.
void sync_file(const std::string& path);

/// Moves a file over another one (or to a free name) in one step; raises StorageError.
void rename_file(const std::string& from, const std::string& to);

/// Copies a file to a new one; raises StorageError.
void copy_file(const std::string& from, const std::string& to);

/// Cuts a file to its first bytes; raises StorageError.
void cut_file(const std::string& path, std::size_t bytes);

/// Lets two files of one folder change names; `first` names a whole file at any moment. Raises StorageError.
void exchange_files(const std::string& first, const std::string& second);

/// Appends text to a file and keeps what is not yet written in memory until flush().
class AppendedFile {
 public:
  /// Opens for appending, creating the file where it is missing; raises StorageError.
  explicit AppendedFile(std::string path);
  ~AppendedFile();
  AppendedFile(const AppendedFile&) = delete;
  AppendedFile& operator=(const AppendedFile&) = delete;

  void append(std::string_view text) { waiting_ += text; }
  /// Hands everything to the operating system; raises StorageError.
  void flush();
  /// Flushes and waits until the content has reached the disk; raises StorageError.
  void sync();
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::string waiting_;
  int descriptor_ = -1;
};

}  // namespace fiberfate
