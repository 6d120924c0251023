// Collects the pairs of one chunk of the neighbour list.
#pragma once

#include "fibers/neighbour_list.hpp"
#include "fibers/rod_cull.hpp"

namespace fiberfate {

/// Finds the pairs whose first entry lies in the bins [begin, end) of the grid: midpoints are culled against
/// the rod, then the rods against each other, both in single precision and never too many.
class PairCollector {
 public:
  PairCollector(const FiberState& state, const NeighbourList& list, double widest, PairCandidates& candidates)
      : state_(state), list_(list), widest_(widest), candidates_(candidates) {}

  void run(Index begin, Index end, RodPairs& pairs);

 private:
  void collect(Index entry);
  void measure(Index entry, RodCull& query, const IntVec3& shift);
  void consider(Index entry, Index other_entry, const IntVec3& shift, float squared_distance);
  [[nodiscard]] RodCull query_of(Index entry) const;
  [[nodiscard]] bool is_own_neighbour(Index rod, Index other) const;

  const FiberState& state_;
  const NeighbourList& list_;
  double widest_;
  PairCandidates& candidates_;
  RodPairs* pairs_ = nullptr;
  int count_ = 0;
};

}  // namespace fiberfate
