// Reads fibers that another run, another program or a microscope left in a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fibers/state.hpp"

namespace fiberfate {

/// Reads the fibers of a checkpoint (.h5), of the last frame of a result (.vtkhdf), of a table with the
/// columns fiber, x_m, y_m, z_m (.csv, nodes of a fiber in consecutive rows), or of the published program's
/// Initial_Positions.txt. Where the file tells kinds of fibers, each gets its own of the materials; else all
/// get the first. The state begins at time zero, at rest, with fresh birth ids. `cell_size` is needed where
/// the file does not tell the cell. Raises InputError with file and line.
[[nodiscard]] FiberState read_fiber_file(const std::string& path, const std::vector<FiberMaterial>& materials,
                                         const std::optional<Vec3>& cell_size);

}  // namespace fiberfate
