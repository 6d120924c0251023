// Writes, replaces and opens checkpoint files, whatever a study keeps in them.
#pragma once

#include <functional>
#include <string>

#include "io/hdf5_file.hpp"
#include "results/recorder.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {

/// Writes a checkpoint file in one step: it is whole under its name or not there; raises StorageError.
void write_checkpoint_file(const std::string& path, const CheckpointBody& body);

/// Writes the folder's checkpoint and keeps the one before as checkpoint.previous.h5.
void rotate_checkpoints(const ResultFolder& folder, const CheckpointBody& body);

/// Opens a checkpoint file; raises StorageError when it is missing or of a format that is not read.
[[nodiscard]] Hdf5File open_checkpoint_file(const std::string& path);

/// Which of the two checkpoints of a folder.
enum class CheckpointAge { newest, previous };

/// Calls `read` with the newest checkpoint of the folder, and where that raises StorageError with the
/// previous one, after a warning; tells which one it was. Raises StorageError when neither can be read.
CheckpointAge read_newest_checkpoint(const ResultFolder& folder,
                                     const std::function<void(const std::string&)>& warn,
                                     const std::function<void(const std::string& path)>& read);

}  // namespace fiberfate
