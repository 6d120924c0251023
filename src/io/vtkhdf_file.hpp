// Writes and reads polylines or polygons over time in the VTKHDF 2 layout (transient PolyData), which
// ParaView opens.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/hdf5_file.hpp"
#include "io/poly_frame.hpp"

namespace fiberfate {

/// Appends frames to a file so that a killed program leaves a readable one.
///
/// HDF5 cannot append in one step: a program that dies while it writes leaves a broken file. So two copies
/// take turns: a frame goes to the copy at path + ".next", which is closed, synced and then changes names
/// with the file at `path`. `path` is therefore whole at any moment, and every frame is written twice but
/// none is copied.
class VtkhdfWriter {
 public:
  /// Prepares to write at `path`, keeping the first `kept_frames` frames of the file there (0: none, and the
  /// file need not exist). Raises StorageError when it has fewer.
  VtkhdfWriter(std::string path, std::int64_t kept_frames);

  /// Appends a frame; raises StorageError, and `path` is then as before.
  void append(const PolyFrame& frame);
  /// Removes the copy; the writer must not be used afterwards.
  void finish();
  [[nodiscard]] std::int64_t frames() const { return frames_; }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void prepare_next(const PolyFrame& frame);
  std::string path_;
  std::string next_;
  std::int64_t frames_ = 0;          ///< in the file at path_
  std::optional<PolyFrame> latest_;  ///< the last frame of path_, where next_ does not have it yet
};

/// Reads the frames of a file.
class VtkhdfReader {
 public:
  /// Opens a file; raises StorageError when it is not one of polylines or polygons over time.
  explicit VtkhdfReader(const std::string& path);
  [[nodiscard]] const std::vector<double>& times() const { return times_; }
  /// Reads one frame; raises StorageError.
  [[nodiscard]] PolyFrame read(std::size_t frame) const;

 private:
  Hdf5File file_;
  std::vector<double> times_;
};

}  // namespace fiberfate
