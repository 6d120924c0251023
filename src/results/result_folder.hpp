// The files of a result folder, and how a run comes to own one.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "results/folder_record.hpp"
#include "results/run_types.hpp"

namespace fiberfate {

/// The folder in which a run leaves its files (docs/formats/results.md).
class ResultFolder {
 public:
  /// Opens the folder of an earlier run to read it; raises InputError when it holds none.
  [[nodiscard]] static ResultFolder open(const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string resolved_case() const { return file("case.resolved.toml"); }
  [[nodiscard]] std::string summary() const { return file("summary.json"); }
  [[nodiscard]] std::string series() const { return file("series.csv"); }
  [[nodiscard]] std::string breaks() const { return file("breaks.csv"); }
  [[nodiscard]] std::string frames() const { return file("result.vtkhdf"); }
  [[nodiscard]] std::string checkpoint() const { return file("checkpoint.h5"); }
  [[nodiscard]] std::string previous_checkpoint() const { return file("checkpoint.previous.h5"); }
  [[nodiscard]] std::string failure() const { return file("failure.h5"); }
  [[nodiscard]] std::string log() const { return file("log.txt"); }
  [[nodiscard]] std::string report() const { return file("report.html"); }
  /// The path of a file of a study's own.
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + '/' + name; }

 private:
  friend class OwnedFolder;
  explicit ResultFolder(std::string path) : path_(std::move(path)) {}
  std::string path_;
};

/// A result folder to which this process alone writes. Until keep() is called, the end of its life leaves the
/// disk as it was: files of the run are removed, those of a result that it replaces are put back.
class OwnedFolder {
 public:
  /// Takes a folder for a new run. Raises InputError when it holds a result and `existing` says to refuse,
  /// when it holds files that the run would write but the program did not make, when another process owns it,
  /// or when it cannot be made.
  [[nodiscard]] static OwnedFolder create(const std::string& path, Existing existing);
  /// Takes the folder of an earlier run to continue it. Raises InputError when it holds none, when another
  /// process owns it, or when its case was edited after the run began.
  [[nodiscard]] static OwnedFolder take(const std::string& path);
  OwnedFolder(OwnedFolder&& other) noexcept;
  OwnedFolder& operator=(OwnedFolder&&) = delete;
  ~OwnedFolder();

  [[nodiscard]] const ResultFolder& folder() const { return folder_; }
  /// Claims a file that the run is about to make. Raises StorageError when there is one that the program did
  /// not make.
  std::string make(const std::string& name);
  /// Writes case.resolved.toml and remembers what it is.
  void write_case(const std::string& text);
  /// Lets the run's files stand, and those of a result that it replaces where they were put meanwhile.
  void stand() { stands_ = true; }
  /// Lets the run's files stand, and removes those of the result that it replaces.
  void keep();
  /// Lets the files of a run that failed stand: here, or, where they would replace an earlier result, in a
  /// new folder beside it, "result.failed". Returns the folder in which they are. Nothing may be made
  /// afterwards.
  std::string set_aside();
  /// Tells the next process that the outcome of this one stands here in full.
  void end() { record_->end(); }
  /// Whether the process before this one left its outcome in full.
  [[nodiscard]] bool was_ended() const { return record_->was_ended(); }
  [[nodiscard]] bool replaces() const { return !earlier_record_.empty(); }

 private:
  OwnedFolder(ResultFolder folder, std::vector<std::string> made_folders);
  void recover();
  void take_back(const char* waiting);
  void put_aside();
  void undo() noexcept;

  ResultFolder folder_;
  std::vector<std::string> made_folders_;  ///< by this run, the outermost first
  std::optional<FolderRecord> record_;
  std::string earlier_record_;  ///< text of the record of the earlier result
  bool stands_ = false;
};

}  // namespace fiberfate
