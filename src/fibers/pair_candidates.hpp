// What the collection of one rod's pairs works on, so that its memory is kept.
#pragma once

#include <vector>

#include "fibers/rod_grid.hpp"

namespace fiberfate {

/// The entries of a grid that may be near a rod.
struct PairCandidates {
  RodGrid::Runs runs;
  std::vector<Index> entries;            ///< RodGrid::Entry, as kernels write them
  std::vector<float> squared_distances;  ///< of entries kept, m²
};

}  // namespace fiberfate
