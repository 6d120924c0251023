// Asks which rods of a run of the grid may be near a given rod.
#pragma once

#include "base/vector.hpp"

namespace fiberfate {

/// Describes the rod that is asked for, and the arrays of the grid. Plain floats, because kernels of several
/// instruction sets share it.
struct RodCull {
  float x, y, z;            ///< midpoint of the rod less the shift of the run, m
  float ax, ay, az;         ///< unit vector along the rod
  float half_length;        ///< m
  float keep;               ///< range + the rod's own margin + rounding, m
  const float* midpoint_x;  ///< of the grid
  const float* midpoint_y;
  const float* midpoint_z;
  const float* half_lengths;
  const float* margins;
};

/// Writes the entries in [begin, end) whose midpoint lies within keep + margin + half length of the rod's
/// segment, and returns how many; no pair of rods nearer than keep + margin is missed. `found` has room for
/// end − begin + 16.
int cull_rods(const RodCull& query, Index begin, Index end, Index* found);

}  // namespace fiberfate
