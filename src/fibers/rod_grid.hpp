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
  using Bin = IndexOf<struct GridBinTag>;
  using Entry = IndexOf<struct GridEntryTag>;

  /// Runs are read in whole vectors; so many entries beyond the last one may be read.
  static constexpr std::size_t padding = 16;

  /// Consecutive entries whose midpoints, moved by the lattice shift, may be near.
  struct Run {
    Entry begin, end;
    IntVec3 shift = IntVec3::Zero();
  };

  /// Bins all rods, with bins no narrower than `bin_width` (m); `margin` is kept with each rod.
  void fill(const FiberState& state, double bin_width, const IndexedVector<RodIndex, double>& margin);

  /// Lists, of the runs that hold every midpoint within `reach` (m) of a midpoint in the given bin, the half
  /// that comes after the bin, beginning with the bin itself: over all bins, every two bins (images told
  /// apart) meet once.
  void runs_ahead(Bin bin, double reach, std::vector<Run>& runs) const;

  [[nodiscard]] Index bin_count() const { return static_cast<Index>(begin_.size()) - 1; }
  /// The first entry of a bin, or the end of all.
  [[nodiscard]] Entry first_entry(Bin bin) const { return begin_[bin]; }
  [[nodiscard]] IndexRange<Entry> entries(Bin bin) const { return {begin_[bin], begin_[bin + 1]}; }

  // One entry a rod, sorted by bin, then by rod.
  using Floats = IndexedVector<Entry, float>;
  Floats x, y, z;                      ///< midpoint, wrapped into the cell, m
  Floats axis_x, axis_y, axis_z;       ///< unit vector along the rod
  Floats half_length;                  ///< m
  Floats margin_of;                    ///< m
  IndexedVector<Entry, RodIndex> rod;  ///< which it is
  IndexedVector<Entry, std::array<std::int16_t, 3>>
      image;  ///< the cell image that the unwrapped midpoint lies in

 private:
  /// A rod before it is sorted.
  struct BinnedRod {
    std::array<float, 3> midpoint, axis;
    float half_length;
    std::array<std::int16_t, 3> image;
    RodIndex rod;
    Bin bin;
  };
  /// Bounds the bins, counted without wrapping, that may hold a midpoint near one in a bin.
  struct Block {
    std::array<int, 3> centre, low, high;
  };

  void bin_rods(const FiberState& state);
  [[nodiscard]] BinnedRod binned(const FiberState& state, RodIndex which) const;
  void sort_bins();
  [[nodiscard]] Block block_around(Bin bin, double reach) const;
  void add_row(const Block& block, int i, int j, std::vector<Run>& runs) const;
  [[nodiscard]] std::array<int, 3> bin_at(const Vec3& midpoint) const;
  [[nodiscard]] Bin bin_index(const std::array<int, 3>& bin) const {
    return Bin((bin[0] * bins_[1] + bin[1]) * bins_[2] + bin[2]);
  }

  std::array<int, 3> bins_ = {1, 1, 1};
  std::array<double, 3> height_ = {1, 1, 1};
  std::array<Boundary, 3> boundary_{};
  Mat3 to_fraction_ = Mat3::Identity();
  IndexedVector<Bin, Entry> begin_;
  std::vector<BinnedRod> unsorted_;
  IndexedVector<Entry, Index> source_;  // places among the unsorted rods
};

}  // namespace fiberfate
