// Collects the pairs of one chunk of the neighbour list.
#pragma once

#include "fibers/neighbour_list.hpp"
#include "fibers/rod_cull.hpp"

namespace fiberfate {

/// Finds the pairs whose first entry lies in given bins of the grid: midpoints are culled against
/// the rod, then the rods against each other, both in single precision and never too many.
class PairCollector {
 public:
  using Entry = RodGrid::Entry;

  PairCollector(const FiberState& state, const NeighbourList& list, double widest, PairCandidates& candidates)
      : state_(state), list_(list), widest_(widest), candidates_(candidates) {}

  void run(IndexRange<RodGrid::Bin> bins, RodPairs& pairs);

 private:
  void collect(Entry entry);
  void measure(Entry entry, RodCull& query, const IntVec3& shift);
  void consider(Entry entry, Entry other_entry, const IntVec3& shift, float squared_distance);
  [[nodiscard]] RodCull query_of(Entry entry) const;
  [[nodiscard]] bool is_own_neighbour(RodIndex rod, RodIndex other) const;

  const FiberState& state_;
  const NeighbourList& list_;
  double widest_;
  PairCandidates& candidates_;
  RodPairs* pairs_ = nullptr;
  int count_ = 0;
};

}  // namespace fiberfate
