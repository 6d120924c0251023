// Finds the closest points of many listed pairs of rods at once.
#pragma once

#include <array>

#include "fibers/rod_pairs.hpp"

namespace fiberfate {

struct FiberState;

/// Squared sine of the angle below which two rods count as parallel: there every point of their overlap is
/// closest to round-off, and the middle of the overlap is taken.
inline constexpr double parallel_sine2 = 1e-12;

/// Bits that say which part of its fiber a rod is.
inline constexpr std::uint8_t first_of_fiber = 1;
inline constexpr std::uint8_t last_of_fiber = 2;
/// Bit of the rods whose pairs are listed anew.
inline constexpr std::uint8_t listed_anew = 4;

/// Receives the closest points of up to `capacity` pairs. Plain doubles, because kernels of several
/// instruction sets share it.
struct SegmentBlock {
  static constexpr int capacity = 64;
  alignas(64) double s[capacity];
  alignas(64) double t[capacity];
  alignas(64) double separation[3][capacity];  ///< from the second rod to the first, m
  alignas(64) double distance[capacity];       ///< m
  alignas(64) std::int32_t wake[capacity];     ///< new value of RodPairs::wake
  alignas(32) Index first[capacity];           ///< rods
  alignas(32) Index second[capacity];
  alignas(32) std::int32_t image[capacity];
  /// Bits of the pairs that may come within range in the coming step; where two rods of a hinge may both
  /// touch a third one there, those of the one that does.
  std::uint8_t near[capacity / 8];
  /// Bits of the pairs whose rods may just have broken apart, or whose axes cross.
  std::uint8_t special[capacity / 8];
};

/// Pairs to be measured: entries of the arrays of RodPairs, and where their rods are.
struct SegmentQuery {
  const Index* first;
  const Index* second;
  const std::int32_t* image;
  const double* position;      ///< of the nodes, three doubles each
  const double* lattice;       ///< by columns
  const std::int32_t* travel;  ///< of every rod (NeighbourList::travel)
  const float* ahead;          ///< of every rod (NeighbourList::ahead), m
  const std::uint8_t* part;    ///< of every rod: first_of_fiber, last_of_fiber
  double range;                ///< m
  double widest_gap;           ///< NeighbourList::widest_gap, m
  double per_quantum;          ///< of travel (NeighbourList::quantum), 1/m
};

/// Fills the block for the pairs numbered which[0 … count), count <= capacity, with the kernel of this
/// processor; closest_points() is its specification. `which` is padded to a multiple of eight.
void find_segment_distances(const SegmentQuery& query, const Index* which, int count, SegmentBlock& block);

/// Writes the numbers of those of `count` pairs whose rods may have come near, reach[first] + reach[second]
/// >= wake, and returns how many. Arrays of pairs are padded to a multiple of sixteen; `awake` has room for
/// count + 16.
int find_awake_pairs(const RodPairs& pairs, IndexedSpan<RodIndex, const std::int32_t> reach, Index* awake);

}  // namespace fiberfate
