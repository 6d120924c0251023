// The record of a result folder: which files the program made there, and which process writes to it.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace fiberfate {

/// Name of the record in a result folder: lines "file NAME", "case DIGEST", "run PROCESS HOST TIME" when a
/// process takes the folder, and "end" when its outcome stands there.
inline constexpr const char* folder_record_name = ".fiberfate";

/// Reads the names of the files that the program made in a folder; nothing where there is no record.
[[nodiscard]] std::set<std::string> recorded_files(const std::string& folder);

/// Raises InputError for a file that is there already and in no record, so that the program did not make it.
[[noreturn]] void refuse_unrecorded(const std::string& path);

/// Adds a file that is about to be made to the record of a folder that another process may hold (a report of
/// a run that goes on); raises StorageError.
void record_file(const std::string& folder, const std::string& name);

/// The record of a folder, held by this process alone. Two processes never hold the same one, also on two
/// machines where their file system knows locks; the lock ends with the process, so that none can go stale.
class FolderRecord {
 public:
  /// Opens or makes the record and locks it. Raises InputError that names the process and its machine when
  /// another one holds it, and StorageError.
  explicit FolderRecord(const std::string& folder);
  ~FolderRecord();
  FolderRecord(FolderRecord&& other) noexcept;
  FolderRecord& operator=(FolderRecord&&) = delete;

  [[nodiscard]] const std::set<std::string>& files() const { return files_; }
  /// Digest of the case that the run began with.
  [[nodiscard]] std::optional<std::uint64_t> case_digest() const { return case_digest_; }
  /// Whether the record was made just now.
  [[nodiscard]] bool is_new() const { return is_new_; }
  /// Whether the process before this one left its outcome in full; it may have been killed before.
  [[nodiscard]] bool was_ended() const { return was_ended_; }

  /// Adds a file before it is made, so that the record is never behind the disk; raises StorageError.
  void add_file(const std::string& name);
  void set_case(std::uint64_t digest);
  /// Tells the next process that the outcome stands in full.
  void end();
  /// Forgets all files and the case: what they were has been put elsewhere.
  void clear();
  /// Makes the record what it was; what cannot be written is left.
  void restore(const std::string& text) noexcept;

 private:
  void lock(const std::string& folder);
  void append(const std::string& line);
  std::string path_;
  int descriptor_ = -1;
  std::set<std::string> files_;
  std::optional<std::uint64_t> case_digest_;
  bool is_new_ = false;
  bool was_ended_ = false;
};

}  // namespace fiberfate
