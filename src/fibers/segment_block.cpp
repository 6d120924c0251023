// Chooses the kernels that filter and measure pairs.
#include "fibers/segment_block.hpp"

#include "base/kernels.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(void find_segment_distances(const SegmentQuery& query, const Index* which, int count,
                                                     SegmentBlock& block))
FIBERFATE_DECLARE_KERNEL(int find_awake_pairs(const Index* first, const Index* second,
                                              const std::int32_t* wake, int count, const std::int32_t* reach,
                                              Index* awake))

void find_segment_distances(const SegmentQuery& query, const Index* which, int count, SegmentBlock& block) {
  return FIBERFATE_KERNEL(find_segment_distances)(query, which, count, block);
}

int find_awake_pairs(const RodPairs& pairs, IndexedSpan<RodIndex, const std::int32_t> reach, Index* awake) {
  const Index* first = numbers(pairs.first).data();
  const Index* second = numbers(pairs.second).data();
  const std::int32_t* wake = pairs.wake.data();
  return FIBERFATE_KERNEL(find_awake_pairs)(first, second, wake, pairs.size(), reach.data(), awake);
}

}  // namespace fiberfate
