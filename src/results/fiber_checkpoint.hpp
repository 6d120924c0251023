// Saves and restores everything that a run of fibers needs in order to continue exactly.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/timer.hpp"
#include "fibers/state.hpp"
#include "results/recorder.hpp"

namespace fiberfate {

/// Counts what a run has written and used so far, over all processes that worked on it.
struct RunRecord {
  std::int64_t series_rows = 0;
  std::int64_t break_rows = 0;
  std::int64_t frames = 0;
  std::int64_t rejections = 0;  ///< trial steps thrown away
  double wall_s = 0;
  double cpu_s = 0;
  PhaseTimes times;
  std::vector<double> stress = {};          ///< mean stress since the last row, as StressMean has it
  std::vector<double> stress_history = {};  ///< what the study keeps of the stresses of all rows so far
};

/// A run at one moment.
struct Checkpoint {
  FiberState state;
  RunRecord record;
  std::string resolved_case;  ///< text of case.resolved.toml
};

/// Writes a checkpoint file in one step (docs/formats/checkpoint.md); raises StorageError.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// Reads a checkpoint file; raises StorageError when it is missing, truncated or damaged.
[[nodiscard]] Checkpoint read_checkpoint(const std::string& path);

/// Saves a checkpoint where a run keeps them; raises StorageError.
void save_checkpoint(Recorder& recorder, const Checkpoint& checkpoint);

/// Saves the state in which a simulation failed; raises StorageError.
void save_failure(Recorder& recorder, const Checkpoint& checkpoint);

/// Reads the newest sound checkpoint of an earlier run, with a warning when that is the one before the last.
/// Raises StorageError when neither can be read.
[[nodiscard]] Checkpoint load_checkpoint(Recorder& recorder);

}  // namespace fiberfate
