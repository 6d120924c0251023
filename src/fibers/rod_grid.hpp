// Sorts rods into the bins of a grid that is laid over the flowing cell.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "fibers/state.hpp"

namespace fiberfate {

/// Bins rods by their midpoints in fractional coordinates, so that a tilted cell needs no special case.
/// Coordinates are kept in single precision: the grid only culls.
class RodGrid {
 public:
  /// Holds one binned rod.
  struct Entry {
    std::array<float, 3> midpoint;   ///< wrapped into the cell, m
    std::array<float, 3> half_axis;  ///< from the midpoint to the rod's end, m
    float half_length;               ///< m
    Index rod;
    std::array<std::int16_t, 3> image;  ///< the cell image that the unwrapped midpoint lies in
  };

  /// Bins all rods with bins no narrower than `bin_width`.
  void fill(const FiberState& state, double bin_width);

  /// Calls visit(entries, shift) for every bin, with its image shift, that may hold midpoints within `reach`
  /// of a midpoint in the given bin.
  template <class Visit>
  void visit_around(const std::array<int, 3>& bin, double reach, const Visit& visit) const {
    const std::array<int, 3> span = bins_within(reach);
    for (int x = -span[0]; x <= span[0]; ++x) {
      for (int y = -span[1]; y <= span[1]; ++y) {
        for (int z = -span[2]; z <= span[2]; ++z) visit_bin({bin[0] + x, bin[1] + y, bin[2] + z}, visit);
      }
    }
  }

  [[nodiscard]] std::array<int, 3> bin_of(const Entry& entry) const;
  [[nodiscard]] std::span<const Entry> entries() const { return entries_; }
  /// Tells where a rod stands in entries().
  [[nodiscard]] Index place_of(Index rod) const { return place_[static_cast<std::size_t>(rod)]; }

 private:
  [[nodiscard]] std::array<int, 3> bins_within(double reach) const;
  [[nodiscard]] std::size_t bin_index(const std::array<int, 3>& bin) const {
    return static_cast<std::size_t>((bin[0] * bins_[1] + bin[1]) * bins_[2] + bin[2]);
  }

  template <class Visit>
  void visit_bin(std::array<int, 3> bin, const Visit& visit) const {
    IntVec3 shift = IntVec3::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const int turns = bin[i] >= 0 ? bin[i] / bins_[i] : -((bins_[i] - 1 - bin[i]) / bins_[i]);
      if (turns != 0 && boundary_[i] != Boundary::periodic) return;
      shift[static_cast<int>(i)] = turns;
      bin[i] -= turns * bins_[i];
    }
    const std::size_t b = bin_index(bin);
    const auto first = static_cast<std::size_t>(begin_[b]);
    const auto count = static_cast<std::size_t>(begin_[b + 1]) - first;
    if (count > 0) visit(std::span<const Entry>(entries_.data() + first, count), shift);
  }

  std::array<int, 3> bins_ = {1, 1, 1};
  std::array<double, 3> height_ = {1, 1, 1};
  std::array<Boundary, 3> boundary_{};
  Mat3 to_fraction_ = Mat3::Identity();
  std::vector<Entry> entries_;  // sorted by bin, then by rod
  std::vector<Index> begin_;    // of each bin in entries_
  std::vector<Index> place_;    // of each rod in entries_
};

}  // namespace fiberfate
