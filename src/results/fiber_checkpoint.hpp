// Saves and restores everything that a run of fibers needs in order to continue exactly.
#pragma once

#include <cstdint>
#include <string>

#include "base/timer.hpp"
#include "fibers/state.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {

class RunLog;

/// Counts what a run has written and used so far, over all processes that worked on it.
struct RunRecord {
  std::int64_t series_rows = 0;
  std::int64_t break_rows = 0;
  std::int64_t frames = 0;
  std::int64_t rejections = 0;  ///< trial steps thrown away
  double wall_s = 0;
  double cpu_s = 0;
  PhaseTimes times;
};

/// Holds a run at one moment.
struct Checkpoint {
  FiberState state;
  RunRecord record;
  std::string resolved_case;  ///< text of case.resolved.toml
};

/// Writes a checkpoint file in one step (docs/formats/checkpoint.md); raises StorageError.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// Reads a checkpoint file; raises StorageError when it is missing, truncated or damaged.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& path);

/// Writes the folder's checkpoint and keeps the one before as checkpoint.previous.h5.
void save_checkpoint(const ResultFolder& folder, const Checkpoint& checkpoint);

/// Reads the folder's newest sound checkpoint, with a warning in the log when that is the previous one.
/// Raises StorageError when neither can be read.
[[nodiscard]] Checkpoint load_checkpoint(const ResultFolder& folder, RunLog& log);

/// Tells whether the folder has a checkpoint, sound or not.
[[nodiscard]] bool has_checkpoint(const ResultFolder& folder);

}  // namespace fiberfate
