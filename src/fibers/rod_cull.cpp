// Chooses the kernel that culls rods.
#include "fibers/rod_cull.hpp"

#include "base/simd.hpp"

namespace fiberfate {

namespace baseline {
int cull_rods(const RodCull& query, Index begin, Index end, Index* found);
}
namespace avx2 {
int cull_rods(const RodCull& query, Index begin, Index end, Index* found);
}
namespace avx512 {
int cull_rods(const RodCull& query, Index begin, Index end, Index* found);
}

int cull_rods(const RodCull& query, Index begin, Index end, Index* found) {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::cull_rods(query, begin, end, found);
    case InstructionSet::avx2:
      return avx2::cull_rods(query, begin, end, found);
    default:
      return baseline::cull_rods(query, begin, end, found);
  }
}

}  // namespace fiberfate
