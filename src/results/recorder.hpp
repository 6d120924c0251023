// Where a study puts what it makes while it runs: its log, rows of tables, frames, checkpoints.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "io/hdf5_file.hpp"
#include "io/poly_frame.hpp"

namespace fiberfate {

/// Fills a new checkpoint file that has its versions already.
using CheckpointBody = std::function<void(Hdf5File&)>;

/// Takes the rows of one table as they are made.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// Adds a row with one number a column.
  virtual void append(std::span<const double> row) = 0;
  /// Lets readers see the rows so far; raises StorageError.
  virtual void flush() = 0;
  /// Makes the rows so far survive a crash of the machine; raises StorageError.
  virtual void sync() = 0;
  [[nodiscard]] virtual std::int64_t rows() const = 0;
  /// A number that stands for the rows so far; 0 where nobody can change them.
  [[nodiscard]] virtual std::uint64_t digest() const { return 0; }
};

/// Takes the frames of one series as they are made.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// Adds a frame; raises StorageError, and what is there already stays as it is.
  virtual void append(const PolyFrame& frame) = 0;
  /// Ends the series; nothing may be added afterwards.
  virtual void finish() = 0;
  [[nodiscard]] virtual std::int64_t frames() const = 0;
};

/// Takes what a study makes while it runs. A folder keeps it (FolderRecorder), or memory (MemoryRecorder).
class Recorder {
 public:
  virtual ~Recorder() = default;

  virtual void note(const std::string& text) = 0;   ///< for the log
  virtual void warn(const std::string& text) = 0;   ///< for the log and for the person
  virtual void error(const std::string& text) = 0;  ///< for the log; the person meets the exception

  /// Opens a table by name ("series"), keeping its first `kept` rows of an earlier run. Raises StorageError
  /// when it has fewer rows or other columns.
  [[nodiscard]] virtual std::unique_ptr<RowSink> open_rows(const std::string& name,
                                                           const std::vector<std::string>& columns,
                                                           std::int64_t kept) = 0;
  /// Opens a series of frames by name ("result"), keeping its first `kept` frames. Raises StorageError when
  /// it has fewer.
  [[nodiscard]] virtual std::unique_ptr<FrameSink> open_frames(const std::string& name,
                                                               std::int64_t kept) = 0;

  /// Whether an earlier run left a checkpoint, sound or not.
  [[nodiscard]] virtual bool has_checkpoint() const = 0;
  /// Whether an earlier run left its outcome in full; it may have been killed between its last checkpoint and
  /// its outcome.
  [[nodiscard]] virtual bool has_outcome() const = 0;
  /// Saves a checkpoint and keeps the one before; raises StorageError.
  virtual void save_checkpoint(const CheckpointBody& body) = 0;
  /// Calls `read` with the newest checkpoint, and where that raises StorageError with the one before, after a
  /// warning. Raises StorageError when neither can be read.
  virtual void read_checkpoint(const std::function<void(const std::string& path)>& read) = 0;
  /// Saves the state in which a simulation failed, and tells the log where.
  virtual void save_failure(const CheckpointBody& body) = 0;
  /// The text of the case as it runs, every key given.
  [[nodiscard]] virtual std::string resolved_case() const = 0;
};

}  // namespace fiberfate
