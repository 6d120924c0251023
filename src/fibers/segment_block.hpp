// Holds pairs of rods side by side for the vectorised search of closest points.
#pragma once

namespace fiberfate {

/// Squared sine of the angle below which two rods count as parallel: there every point of their overlap is
/// closest to round-off, and the middle of the overlap is taken.
inline constexpr double parallel_sine2 = 1e-12;

/// Holds up to `capacity` pairs: rod 1 from x1 to x1 + first, rod 2 from x2 to x2 + second, offset = x1 − x2.
struct SegmentBlock {
  static constexpr int capacity = 64;
  alignas(64) double offset[3][capacity];
  alignas(64) double first[3][capacity];
  alignas(64) double second[3][capacity];
  alignas(64) double s[capacity];
  alignas(64) double t[capacity];
  alignas(64) double separation[3][capacity];  ///< from the second rod to the first, m
  alignas(64) double distance[capacity];       ///< m
};

/// Fills s, t, separation and distance of the first `count` pairs, with the kernel of this processor. Unused
/// pairs up to the next multiple of eight must hold finite rods of non-zero length.
void find_segment_distances(SegmentBlock& block, int count);

}  // namespace fiberfate
