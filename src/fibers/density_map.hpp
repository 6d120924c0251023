// Measures how densely fibers lie in columns through the cell, seen along one of its directions.
#pragma once

#include <vector>

#include "fibers/state.hpp"

namespace fiberfate {

/// The two lattice vectors beside one, in rising order.
struct OtherDirections {
  int across, up;
};
[[nodiscard]] constexpr OtherDirections other_directions(int along) {
  return {along == 0 ? 1 : 0, along == 2 ? 1 : 2};
}

/// The shares of volume that fibers take in columns along a lattice vector, over an even grid of the other
/// two. Fractions of the cell are counted, so that the grid follows the lattice where the cell is tilted.
struct DensityMap {
  int along = 2;                        ///< number of the lattice vector, 0 to 2
  int across = 0, up = 1;               ///< the other two, in rising order
  int bins = 0;                         ///< along each of them
  std::vector<double> volume_fraction;  ///< row after row of `up`, columns along `across`
};

/// Measures a map. Rods are taken as lines of their cross-section, cut into pieces much shorter than a bin;
/// the volume of a rod is that of its cylinder. What lies outside of walls is left out. Raises InputError
/// unless there is a bin and `along` is 0 to 2.
[[nodiscard]] DensityMap density_map(const FiberState& state, int along, int bins);

}  // namespace fiberfate
