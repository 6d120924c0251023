// Saves and restores fillings, so that a run continues bitwise.
#pragma once

#include <cstdint>
#include <string>

#include "molding/filling.hpp"
#include "results/recorder.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {

/// Counts what a run has written and used so far, over all processes that worked on it.
struct MoldingRecord {
  std::int64_t series_rows = 0;
  std::int64_t frames = 0;
  double wall_s = 0;
  double cpu_s = 0;
  double greatest_pressure = 0;  ///< at the sprue, Pa
};

/// A filling at one moment; the shell is kept since the file that it came from may be gone.
struct MoldingCheckpoint {
  Shell shell;
  FillingState state;
  MoldingRecord record;
};

/// Writes one file; raises StorageError.
void write_molding(const std::string& path, const MoldingCheckpoint& checkpoint);
/// Saves a checkpoint where a run keeps them; raises StorageError.
void save_checkpoint(Recorder& recorder, const MoldingCheckpoint& checkpoint);
/// Saves the state in which a filling failed; raises StorageError.
void save_failure(Recorder& recorder, const MoldingCheckpoint& checkpoint);
/// Reads the newest sound checkpoint of an earlier run; raises StorageError when there is none.
[[nodiscard]] MoldingCheckpoint load_molding(Recorder& recorder);
/// Reads the newest sound checkpoint of a result; raises StorageError when there is none.
[[nodiscard]] MoldingCheckpoint load_molding(const ResultFolder& folder);
/// Reads one file; raises StorageError where it is damaged or its parts do not fit each other.
[[nodiscard]] MoldingCheckpoint read_molding(const std::string& path);
/// Makes the filling that goes on from there; raises StorageError where it is not one of these parameters.
[[nodiscard]] Filling filling_from(MoldingCheckpoint checkpoint, const FillingParams& params);

}  // namespace fiberfate
