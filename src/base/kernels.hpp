// Kernels for every instruction set, and the choice of the one for this processor.
#pragma once

#include "base/simd.hpp"

namespace fiberfate {

/// Picks, of a function compiled for every instruction set, the one that instruction_set() tells.
template <class Function>
[[nodiscard]] Function* pick_kernel(Function* baseline, Function* avx2, Function* avx512) {
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512;
    case InstructionSet::avx2:
      return avx2;
    default:
      return baseline;
  }
}

}  // namespace fiberfate

/// Declares a function that a kernel header (base/simd.hpp) defines, in the namespaces of all instruction
/// sets.
#define FIBERFATE_DECLARE_KERNEL(...) \
  namespace baseline {                \
  __VA_ARGS__;                        \
  }                                   \
  namespace avx2 {                    \
  __VA_ARGS__;                        \
  }                                   \
  namespace avx512 {                  \
  __VA_ARGS__;                        \
  }

/// Is that function for this processor.
#define FIBERFATE_KERNEL(name) pick_kernel(&baseline::name, &avx2::name, &avx512::name)
