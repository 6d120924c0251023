// How far a rheometer is: what its checkpoints keep.
#pragma once

#include <optional>
#include <string>

#include "fibers/state.hpp"
#include "results/recorder.hpp"
#include "studies/rheometer/cell_run.hpp"

namespace fiberfate {

/// The rows of finished runs, and the run that is going.
struct RheometerProgress {
  CsvTable readings{reading_columns()};  ///< rheometer.csv
  std::optional<FiberState> state = {};  ///< of the run that is going, or of the last one that ended
  std::optional<RunNotes> going = {};    ///< of the run that is going; nothing between runs
  double wall_s = 0;
  double cpu_s = 0;
  std::string resolved_case = {};

  /// Takes what a run is at.
  void take(const CellRun& run);
};

/// Saves a checkpoint, which has the format of a sheared cell (docs/formats/checkpoint.md); raises
/// StorageError.
void save_checkpoint(Recorder& recorder, const RheometerProgress& progress);
/// Saves the state in which a simulation failed; raises StorageError.
void save_failure(Recorder& recorder, const RheometerProgress& progress);
/// Reads the newest sound checkpoint; raises StorageError.
[[nodiscard]] RheometerProgress load_progress(Recorder& recorder);

}  // namespace fiberfate
