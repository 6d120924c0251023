// Chooses the repulsion kernel for this processor.
#include "packing/rod_repulsion.hpp"

#include "base/kernels.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(void repel_rods(const RepulsionInput& input, const RepulsionLaw& law, int first,
                                         int last, RepulsionLoad* loads))
FIBERFATE_DECLARE_KERNEL(void measure_distances(const RepulsionInput& input, int subject, int count,
                                                double* distances))
FIBERFATE_DECLARE_KERNEL(int search_rods(const CentreArrays& centres, const SearchRod& rod, int first,
                                         int last, std::int32_t* near))

RepulsionKernel repulsion_kernel() {
  return FIBERFATE_KERNEL(repel_rods);
}

DistanceKernel distance_kernel() {
  return FIBERFATE_KERNEL(measure_distances);
}

SearchKernel search_kernel() {
  return FIBERFATE_KERNEL(search_rods);
}

}  // namespace fiberfate
