// Writes VTK XML files for ParaView versions that do not read VTKHDF over time.
#pragma once

#include <string>
#include <vector>

#include "io/poly_frame.hpp"
#include "io/prism_file.hpp"

namespace fiberfate {

/// Writes one frame as .vtp (PolyData, appended raw binary); raises StorageError.
void write_vtp(const std::string& path, const PolyFrame& frame);

/// Writes prisms as .vtu (UnstructuredGrid, appended raw binary); raises StorageError.
void write_vtu(const std::string& path, const PrismMesh& prisms);

/// One file of a series.
struct SeriesMember {
  double time = 0;   ///< s
  std::string file;  ///< relative to the .pvd
};

/// Writes the .pvd file that ties a series of .vtp files to their times; raises StorageError.
void write_pvd(const std::string& path, const std::vector<SeriesMember>& members);

}  // namespace fiberfate
