// Lays out eight orientation states for the compiled closure kernels.
#pragma once

#include "base/kernels.hpp"
#include "microstructure/closure_kind.hpp"

namespace fiberfate {

/// Eight states; arrays are [component][8], components in the order 11, 22, 33, 23, 31, 12, aligned to
/// 64 bytes.
struct ClosureBlock {
  const double* second;     ///< A2
  const double* symmetric;  ///< G
  double* contracted;       ///< A4(A2) : G
};

FIBERFATE_DECLARE_KERNEL(void contract_closures(Closure closure, const ClosureBlock& block))
/// Decomposes eight symmetric tensors; `values` is [3][8], `axes` [axis][component][8].
FIBERFATE_DECLARE_KERNEL(void find_frames(const double* tensors, double* values, double* axes))

}  // namespace fiberfate
