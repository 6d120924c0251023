// Chooses the repulsion kernel for this processor.
#include "packing/rod_repulsion.hpp"

#include "base/simd.hpp"

namespace fiberfate {

#define FIBERFATE_DECLARE_KERNELS(set)                                                            \
  namespace set {                                                                                 \
  void repel_rods(const RepulsionInput& input, const RepulsionLaw& law, int first, int last,      \
                  RepulsionLoad* loads);                                                          \
  void measure_distances(const RepulsionInput& input, int subject, int count, double* distances); \
  int search_rods(const CentreArrays& centres, const SearchRod& rod, int first, int last,         \
                  std::int32_t* near);                                                            \
  }
FIBERFATE_DECLARE_KERNELS(baseline)
FIBERFATE_DECLARE_KERNELS(avx2)
FIBERFATE_DECLARE_KERNELS(avx512)
#undef FIBERFATE_DECLARE_KERNELS

RepulsionKernel repulsion_kernel() {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::repel_rods;
    case InstructionSet::avx2:
      return avx2::repel_rods;
    default:
      return baseline::repel_rods;
  }
}

DistanceKernel distance_kernel() {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::measure_distances;
    case InstructionSet::avx2:
      return avx2::measure_distances;
    default:
      return baseline::measure_distances;
  }
}

SearchKernel search_kernel() {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::search_rods;
    case InstructionSet::avx2:
      return avx2::search_rods;
    default:
      return baseline::search_rods;
  }
}

}  // namespace fiberfate
