// Collects the pairs of one chunk of the neighbour list.
#pragma once

#include "fibers/neighbour_list.hpp"
#include "fibers/rod_cull.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate {

/// Finds the pairs whose first entry lies in given bins of the grid: midpoints are culled against
/// the rod, then the rods against each other, both in single precision and never too many.
class PairCollector {
 public:
  using Entry = RodGrid::Entry;
  using Bins = IndexRange<RodGrid::Bin>;

  PairCollector(const NeighbourList& list, const IndexedVector<RodIndex, double>& rod_length,
                PairCandidates& candidates);

  /// Lists every pair whose first entry lies in the bins.
  void list(Bins bins, RodPairs& pairs);
  /// Adds the pairs of entries whose rods are listed anew; of two such rods the first one adds the pair.
  void add(std::span<const Entry> entries, RodPairs& pairs);

 private:
  void make_room();
  void collect(Entry entry);
  void consider(Entry entry, Entry other_entry, const IntVec3& shift, float squared_distance);
  [[nodiscard]] RodCull query_of(Entry entry) const;
  [[nodiscard]] bool is_listed_anew(RodIndex rod) const { return (list_.part_[rod] & listed_anew) != 0; }
  [[nodiscard]] bool is_own_neighbour(RodIndex rod, RodIndex other) const;
  [[nodiscard]] std::int32_t wake(RodIndex rod, RodIndex other, double distance) const;

  const NeighbourList& list_;
  const IndexedVector<RodIndex, double>& rod_length_;
  PairCandidates& candidates_;
  RodCull fluid_{};  // what all queries share
  RodPairs* pairs_ = nullptr;
  bool is_renewing_ = false;
};

}  // namespace fiberfate
