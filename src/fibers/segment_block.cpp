// Fills blocks of pairs and chooses the kernel for closest points.
#include "fibers/segment_block.hpp"

#include "base/simd.hpp"
#include "fibers/state.hpp"

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

void SegmentBlock::put(int place, const FiberState& state, Index first_rod, Index second_rod,
                       const std::array<std::int8_t, 3>& image) {
  const auto i = static_cast<std::size_t>(first_rod);
  const auto j = static_cast<std::size_t>(second_rod);
  const Vec3& x = state.position[i];
  const Vec3& y = state.position[j];
  const Mat3& h = state.cell.lattice;
  const double a = image[0], b = image[1], c = image[2];
  for (int d = 0; d < 3; ++d) {
    offset[d][place] = x[d] - y[d] - (h(d, 0) * a + h(d, 1) * b + h(d, 2) * c);
    first[d][place] = state.position[i + 1][d] - x[d];
    second[d][place] = state.position[j + 1][d] - y[d];
  }
}

void SegmentBlock::fill_up(int count) {
  for (int lane = count; lane % lanes != 0; ++lane) {
    for (int d = 0; d < 3; ++d) {
      offset[d][lane] = offset[d][0];
      first[d][lane] = first[d][0];
      second[d][lane] = second[d][0];
    }
  }
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
