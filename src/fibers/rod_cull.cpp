// Chooses the kernels that cull rods.
#include "fibers/rod_cull.hpp"

#include "base/simd.hpp"

namespace fiberfate {

namespace baseline {
int cull_rods(const RodCull& query, Index begin, Index end, Index* found);
int keep_near_rods(const RodCull& query, Index* entries, int count, Index* found, float* squared_distance);
}  // namespace baseline
namespace avx2 {
int cull_rods(const RodCull& query, Index begin, Index end, Index* found);
int keep_near_rods(const RodCull& query, Index* entries, int count, Index* found, float* squared_distance);
}  // namespace avx2
namespace avx512 {
int cull_rods(const RodCull& query, Index begin, Index end, Index* found);
int keep_near_rods(const RodCull& query, Index* entries, int count, Index* found, float* squared_distance);
}  // namespace avx512

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

int keep_near_rods(const RodCull& query, Index* entries, int count, Index* found, float* squared_distance) {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::keep_near_rods(query, entries, count, found, squared_distance);
    case InstructionSet::avx2:
      return avx2::keep_near_rods(query, entries, count, found, squared_distance);
    default:
      return baseline::keep_near_rods(query, entries, count, found, squared_distance);
  }
}

}  // namespace fiberfate
