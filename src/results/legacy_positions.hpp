// Reads Initial_Positions.txt of the published program.
#pragma once

#include <string>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// The nodes of one fiber of a legacy deck, m.
struct LegacyFiber {
  std::vector<Vec3> nodes;
  bool is_stationary = false;  ///< some node is marked as held in place
};

/// Reads "number of fibers; per fiber the number of nodes, then per node: is_stationary x y z".
/// Raises InputError with file and line.
[[nodiscard]] std::vector<LegacyFiber> read_legacy_positions(const std::string& path);

}  // namespace fiberfate
