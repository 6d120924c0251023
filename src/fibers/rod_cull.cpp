// Chooses the kernels that cull rods.
#include "fibers/rod_cull.hpp"

#include "base/kernels.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(int cull_rods(const RodCull& query, const EntryRun* runs, int count, Index* found))
FIBERFATE_DECLARE_KERNEL(int keep_near_rods(const RodCull& query, Index* entries, int count, Index* found,
                                            float* squared_distance))

int cull_rods(const RodCull& query, const EntryRun* runs, int count, Index* found) {
  return FIBERFATE_KERNEL(cull_rods)(query, runs, count, found);
}

int keep_near_rods(const RodCull& query, Index* entries, int count, Index* found, float* squared_distance) {
  return FIBERFATE_KERNEL(keep_near_rods)(query, entries, count, found, squared_distance);
}

}  // namespace fiberfate
