// Holds pairs of rods side by side for the vectorised search of closest points.
#pragma once

#include <array>
#include <cstdint>

#include "base/vector.hpp"

namespace fiberfate {

struct FiberState;

/// Squared sine of the angle below which two rods count as parallel: there every point of their overlap is
/// closest to round-off, and the middle of the overlap is taken.
inline constexpr double parallel_sine2 = 1e-12;

/// Holds up to `capacity` pairs: rod 1 from x1 to x1 + first, rod 2 from x2 to x2 + second, offset = x1 − x2.
struct SegmentBlock {
  static constexpr int capacity = 64;
  static constexpr int lanes = 8;
  alignas(64) double offset[3][capacity];
  alignas(64) double first[3][capacity];
  alignas(64) double second[3][capacity];
  alignas(64) double s[capacity];
  alignas(64) double t[capacity];
  alignas(64) double separation[3][capacity];  ///< from the second rod to the first, m
  alignas(64) double distance[capacity];       ///< m

  /// Puts two rods of a state into a place, the second one in the given image.
  void put(int place, const FiberState& state, Index first_rod, Index second_rod,
           const std::array<std::int8_t, 3>& image);
  /// Repeats the first pair up to the next multiple of `lanes`, because pairs are worked on in whole packs.
  void fill_up(int count);
};

/// Fills s, t, separation and distance of the first `count` pairs (rounded up to whole packs), with the
/// kernel of this processor; closest_points() is its specification.
void find_segment_distances(SegmentBlock& block, int count);

}  // namespace fiberfate
