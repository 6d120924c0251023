// Collects the pairs of one chunk of the neighbour list.
#pragma once

#include <vector>

#include "fibers/neighbour_list.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate {

/// Finds the pairs whose first entry lies in the bins [begin, end) of the grid: cull there, then exact
/// distances.
class PairCollector {
 public:
  PairCollector(const FiberState& state, const NeighbourList& list, double widest)
      : state_(state), list_(list), widest_(widest) {}

  void run(Index begin, Index end, std::vector<RodPair>& pairs);

 private:
  void cull(Index entry);
  void consider(Index entry, Index other_entry, const IntVec3& shift);
  void add(const RodPair& pair);
  void measure();
  [[nodiscard]] bool is_own_neighbour(Index rod, Index other) const;

  const FiberState& state_;
  const NeighbourList& list_;
  double widest_;
  std::vector<RodPair>* pairs_ = nullptr;
  std::vector<RodGrid::Run> runs_;
  std::vector<Vec3> shifts_;  // of the runs, m
  std::vector<Index> found_;
  SegmentBlock block_;
  std::array<RodPair, SegmentBlock::capacity> candidate_{};
  int count_ = 0;
};

}  // namespace fiberfate
