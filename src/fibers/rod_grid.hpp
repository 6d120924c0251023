// Sorts rods into the bins of a grid that is laid over the flowing cell.
#pragma once

#include <array>
#include <vector>

#include "fibers/state.hpp"

namespace fiberfate {

/// Bins rods by their midpoints in fractional coordinates, so that a tilted cell needs no special case.
///
/// Entries are sorted by bin; bins that follow one another in the third direction lie side by side, so that a
/// row of them is one run. Coordinates are kept in single precision: the grid only culls.
class RodGrid {
 public:
  /// Runs are read in whole vectors; so many entries beyond the last one may be read.
  static constexpr std::size_t padding = 16;

  /// Consecutive entries whose midpoints, moved by the lattice shift, may be near.
  struct Run {
    Index begin = 0;
    Index end = 0;
    IntVec3 shift = IntVec3::Zero();
  };

  /// Bins all rods, with bins no narrower than `bin_width` (m); `margin` is kept with each rod.
  void fill(const FiberState& state, double bin_width, const std::vector<double>& margin);

  /// Lists, of the runs that hold every midpoint within `reach` (m) of a midpoint in the given bin, the half
  /// that comes after the bin, beginning with the bin itself: over all bins, every two bins (images told
  /// apart) meet once.
  void runs_ahead(Index bin, double reach, std::vector<Run>& runs) const;

  [[nodiscard]] Index bin_count() const { return static_cast<Index>(begin_.size()) - 1; }
  /// The first entry of a bin; its last one comes before the next bin's first.
  [[nodiscard]] Index first_entry(Index bin) const { return begin_[static_cast<std::size_t>(bin)]; }

  // One entry a rod, sorted by bin, then by rod.
  std::vector<float> x, y, z;                      ///< midpoint, wrapped into the cell, m
  std::vector<float> axis_x, axis_y, axis_z;       ///< unit vector along the rod
  std::vector<float> half_length;                  ///< m
  std::vector<float> margin_of;                    ///< m
  std::vector<Index> rod;                          ///< number of the rod
  std::vector<std::array<std::int16_t, 3>> image;  ///< the cell image that the unwrapped midpoint lies in

 private:
  /// A rod before it is sorted.
  struct BinnedRod {
    std::array<float, 3> midpoint, axis;
    float half_length;
    std::array<std::int16_t, 3> image;
    Index rod;
    Index bin;
  };
  /// Bounds the bins, counted without wrapping, that may hold a midpoint near one in a bin.
  struct Block {
    std::array<int, 3> centre, low, high;
  };

  void bin_rods(const FiberState& state);
  void sort_bins();
  [[nodiscard]] Block block_around(Index bin, double reach) const;
  void add_row(const Block& block, int i, int j, std::vector<Run>& runs) const;
  [[nodiscard]] std::array<int, 3> bin_at(const Vec3& midpoint) const;
  [[nodiscard]] std::size_t bin_index(const std::array<int, 3>& bin) const {
    return static_cast<std::size_t>((bin[0] * bins_[1] + bin[1]) * bins_[2] + bin[2]);
  }

  std::array<int, 3> bins_ = {1, 1, 1};
  std::array<double, 3> height_ = {1, 1, 1};
  std::array<Boundary, 3> boundary_{};
  Mat3 to_fraction_ = Mat3::Identity();
  std::vector<Index> begin_;  // of each bin in the entries
  std::vector<BinnedRod> unsorted_;
  std::vector<Index> source_;  // of the entries among the unsorted rods
};

}  // namespace fiberfate
