// Chooses the kernel for closest points.
#include "fibers/segment_block.hpp"

#include "base/simd.hpp"

namespace fiberfate {

namespace baseline {
void find_segment_distances(SegmentBlock& block, int count);
}
namespace avx2 {
void find_segment_distances(SegmentBlock& block, int count);
}
namespace avx512 {
void find_segment_distances(SegmentBlock& block, int count);
}

void find_segment_distances(SegmentBlock& block, int count) {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::find_segment_distances(block, count);
    case InstructionSet::avx2:
      return avx2::find_segment_distances(block, count);
    default:
      return baseline::find_segment_distances(block, count);
  }
}

}  // namespace fiberfate
