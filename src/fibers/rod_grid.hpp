// Sorts rods into the bins of a grid that is laid over the flowing cell.
#pragma once

#include <array>
#include <vector>

#include "fibers/cell.hpp"
#include "fibers/fiber_nodes.hpp"
#include "fibers/rod_cull.hpp"

namespace fiberfate {

/// Bins rods by their midpoints in fractional coordinates, so that a tilted cell needs no special case.
///
/// Entries are sorted by bin; bins that follow one another in the third direction lie side by side, so that a
/// row of them is one run. Coordinates are kept in single precision: the grid only culls.
///
/// The grid stands as the fluid stood when it was filled; fractional coordinates do not change as both flow.
/// A rod that has moved relative to the fluid stays in its bin, and is looked for so much farther.
class RodGrid {
 public:
  using Bin = IndexOf<struct GridBinTag>;
  using Entry = IndexOf<struct GridEntryTag>;

  /// Runs are read in whole vectors; so many entries beyond the last one may be read.
  static constexpr std::size_t padding = 16;

  /// Runs of entries whose midpoints, moved by the lattice shift, may be near.
  struct Runs {
    /// Consecutive runs with one shift.
    struct Group {
      IntVec3 shift;
      int end;  ///< in runs
    };
    std::vector<EntryRun> runs;
    std::vector<Group> groups;
    [[nodiscard]] std::size_t entries() const;
  };

  /// Bins all rods, with bins no narrower than `bin_width` (m); `margin` is kept with each rod.
  void fill(const FiberNodes& fibers, const Cell& cell, double bin_width,
            const IndexedVector<RodIndex, double>& margin);

  /// Measures bins in the cell as it has flowed since.
  void flow_with(const Cell& cell);

  /// Writes where the rod of an entry is now, in the frame of the grid, and its margin.
  void renew(Entry entry, const Segment& rod, double margin);
  /// Gives all rods new numbers, which keep their order; `end` is beyond them.
  void renumber(const IndexedVector<RodIndex, RodIndex>& numbers, RodIndex end);
  [[nodiscard]] Entry entry_of(RodIndex which) const { return entry_of_[which]; }
  /// Distance that a rod has moved in the frame of the grid since it was binned, m at most.
  [[nodiscard]] double strayed(Entry entry) const { return strayed_[entry]; }

  /// Lists, of the runs that hold every midpoint within `reach` (m) of a midpoint in the given bin, the half
  /// that comes after the bin, beginning with the bin itself: over all bins, every two bins (images told
  /// apart) meet once.
  void runs_ahead(Bin bin, double reach, Runs& runs) const;
  /// Lists all runs that hold a midpoint within `reach` (m) of that of an entry, wherever it has strayed.
  void runs_around(Entry entry, double reach, Runs& runs) const;

  [[nodiscard]] Index bin_count() const { return static_cast<Index>(begin_.size()) - 1; }
  /// The first entry of a bin, or the end of all.
  [[nodiscard]] Entry first_entry(Bin bin) const { return begin_[bin]; }
  [[nodiscard]] IndexRange<Entry> entries(Bin bin) const { return {begin_[bin], begin_[bin + 1]}; }
  [[nodiscard]] Vec3 midpoint(Entry entry) const { return {x[entry], y[entry], z[entry]}; }
  [[nodiscard]] Vec3 axis(Entry entry) const { return {axis_x[entry], axis_y[entry], axis_z[entry]}; }

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
  /// Bins from `low` to `high` in every direction, counted without wrapping.
  struct Block {
    std::array<int, 3> low, high;
  };
  /// Bins in one direction that lie in one image.
  struct Stretch {
    int begin, end, turns;
  };

  void bin_rods(const FiberNodes& fibers);
  [[nodiscard]] BinnedRod binned(const Segment& one_rod) const;
  void sort_bins();
  void keep_within_walls(Block& block) const;
  void add_block(const Block& block, Runs& runs) const;
  [[nodiscard]] Stretch stretch_from(int direction, int low, int high) const;
  [[nodiscard]] std::array<int, 3> bin_at(const Vec3& midpoint) const;
  [[nodiscard]] Bin bin_index(const std::array<int, 3>& bin) const {
    return Bin((bin[0] * bins_[1] + bin[1]) * bins_[2] + bin[2]);
  }

  std::array<int, 3> bins_ = {1, 1, 1};
  std::array<double, 3> height_ = {1, 1, 1};
  Mat3 to_fraction_ = Mat3::Identity();
  IndexedVector<Bin, Entry> begin_;
  std::vector<BinnedRod> unsorted_;
  IndexedVector<Entry, Index> source_;  // places among the unsorted rods
  IndexedVector<RodIndex, Entry> entry_of_;
  Floats strayed_;  // paths in the frame of the grid, m
  Cell cell_;       // when the grid was filled
};

}  // namespace fiberfate
