// Saves and restores fillings, so that a run continues bitwise.
#pragma once

#include <cstdint>
#include <string>

#include "molding/filling_state.hpp"
#include "molding/shell_mesh.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {

class RunLog;

/// Counts what a run has written and used so far, over all processes that worked on it.
struct MoldingRecord {
  std::int64_t series_rows = 0;
  std::int64_t frames = 0;
  double wall_s = 0;
  double cpu_s = 0;
  double greatest_pressure = 0;  ///< at the sprue, Pa
};

/// Holds a filling at one moment; the shell is kept since the file that it came from may be gone.
struct MoldingCheckpoint {
  Shell shell;
  FillingState state;
  MoldingRecord record;
};

/// Writes the folder's checkpoint and keeps the one before; raises StorageError.
void save_molding(const ResultFolder& folder, const MoldingCheckpoint& checkpoint);
/// Writes a checkpoint to a file of its own; raises StorageError.
void write_molding(const std::string& path, const MoldingCheckpoint& checkpoint);
/// Reads the folder's newest sound checkpoint; raises StorageError when there is none.
[[nodiscard]] MoldingCheckpoint load_molding(const ResultFolder& folder, RunLog& log);
/// Reads one file; raises StorageError.
[[nodiscard]] MoldingCheckpoint read_molding(const std::string& path);

}  // namespace fiberfate
