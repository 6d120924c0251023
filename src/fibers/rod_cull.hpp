// Asks which rods of a run of the grid may be near a given rod.
#pragma once

#include "base/vector.hpp"

namespace fiberfate {

/// Describes the rod that is asked for, and the arrays of the grid, which stand as the fluid stood when the
/// grid was filled. Plain floats, because kernels of several instruction sets share it.
struct RodCull {
  float fluid[3][3];        ///< what the fluid has done since, by rows
  float stretch;            ///< by how much it lengthens a rod at most
  float x, y, z;            ///< midpoint of the rod less the shift of the run, in the grid, m
  float ax, ay, az;         ///< unit vector along the rod now
  float half_length;        ///< now, m
  float keep;               ///< range + the rod's own margin + rounding, m
  const float* midpoint_x;  ///< of the grid
  const float* midpoint_y;
  const float* midpoint_z;
  const float* axis_x;
  const float* axis_y;
  const float* axis_z;
  const float* half_lengths;
  const float* margins;
};

/// Consecutive entries of the grid.
struct EntryRun {
  Index begin, end;
};

/// Entries beyond the last one that the kernels below may write.
inline constexpr Index cull_overrun = 16;

/// Writes the entries of so many runs whose midpoint lies within keep + margin + half length of the rod's
/// segment, and returns how many; no pair of rods nearer than keep + margin is missed. `found` has room for
/// all entries of the runs + cull_overrun.
int cull_rods(const RodCull& query, const EntryRun* runs, int count, Index* found);

/// Keeps, of `count` entries, those whose segment lies within keep + margin of the rod's segment; writes
/// them and their squared distances (m²), and returns how many. All arrays have room for count +
/// cull_overrun; `entries` and `found` may be the same.
int keep_near_rods(const RodCull& query, Index* entries, int count, Index* found, float* squared_distance);

}  // namespace fiberfate
