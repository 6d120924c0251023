// Chooses the kernels that filter and measure pairs.
#include "fibers/segment_block.hpp"

#include "base/simd.hpp"

namespace fiberfate {

namespace baseline {
void find_segment_distances(const SegmentQuery& query, const Index* which, int count, SegmentBlock& block);
int find_awake_pairs(const Index* first, const Index* second, const float* wake, int count,
                     const float* reach, Index* awake);
}  // namespace baseline
namespace avx2 {
void find_segment_distances(const SegmentQuery& query, const Index* which, int count, SegmentBlock& block);
int find_awake_pairs(const Index* first, const Index* second, const float* wake, int count,
                     const float* reach, Index* awake);
}  // namespace avx2
namespace avx512 {
void find_segment_distances(const SegmentQuery& query, const Index* which, int count, SegmentBlock& block);
int find_awake_pairs(const Index* first, const Index* second, const float* wake, int count,
                     const float* reach, Index* awake);
}  // namespace avx512

void find_segment_distances(const SegmentQuery& query, const Index* which, int count, SegmentBlock& block) {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::find_segment_distances(query, which, count, block);
    case InstructionSet::avx2:
      return avx2::find_segment_distances(query, which, count, block);
    default:
      return baseline::find_segment_distances(query, which, count, block);
  }
}

int find_awake_pairs(const RodPairs& pairs, const float* reach, Index* awake) {
  const Index* first = pairs.first.data();
  const Index* second = pairs.second.data();
  const float* wake = pairs.wake.data();
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::find_awake_pairs(first, second, wake, pairs.size(), reach, awake);
    case InstructionSet::avx2:
      return avx2::find_awake_pairs(first, second, wake, pairs.size(), reach, awake);
    default:
      return baseline::find_awake_pairs(first, second, wake, pairs.size(), reach, awake);
  }
}

}  // namespace fiberfate
