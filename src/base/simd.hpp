// Gives eight doubles that compute side by side, and says which instruction set this processor offers.
//
// Kernels are headers "*.kernel.hpp", compiled once for each instruction set into a namespace of that name
// (cmake/FiberfateKernels.cmake) and chosen at run time. They must not instantiate anything of the standard
// library or Eigen: the linker would keep one copy, perhaps the one that this processor cannot run.
#pragma once

#include <cstdint>

namespace fiberfate {

/// Names the instruction sets for which kernels are compiled.
enum class InstructionSet { baseline, avx2, avx512 };

/// Tells the best instruction set of this processor; the environment variable FIBERFATE_ISA
/// ("baseline", "avx2", "avx512") asks for a lesser one.
[[nodiscard]] InstructionSet instruction_set();
[[nodiscard]] const char* name(InstructionSet set);

}  // namespace fiberfate

#ifdef FIBERFATE_ISA
namespace fiberfate::FIBERFATE_ISA {

inline constexpr int lanes = 8;
typedef double Pack __attribute__((vector_size(64)));
typedef std::int64_t Mask __attribute__((vector_size(64)));

static inline __attribute__((always_inline)) Pack load(const double* from) {
  return *reinterpret_cast<const Pack*>(from);
}
static inline __attribute__((always_inline)) void store(double* to, const Pack& pack) {
  *reinterpret_cast<Pack*>(to) = pack;
}
static inline __attribute__((always_inline)) Pack broadcast(double x) {
  return Pack{x, x, x, x, x, x, x, x};
}
/// Takes `yes` where the mask is set, else `no`.
static inline __attribute__((always_inline)) Pack choose(const Mask& mask, const Pack& yes, const Pack& no) {
  return mask ? yes : no;
}
static inline __attribute__((always_inline)) Pack smaller(const Pack& a, const Pack& b) {
  return a < b ? a : b;
}
static inline __attribute__((always_inline)) Pack larger(const Pack& a, const Pack& b) {
  return a > b ? a : b;
}
static inline __attribute__((always_inline)) Pack clamp(const Pack& x, double low, double high) {
  return smaller(larger(x, broadcast(low)), broadcast(high));
}
static inline __attribute__((always_inline)) Pack square_root(const Pack& x) {
  Pack root;
  for (int i = 0; i < lanes; ++i) root[i] = __builtin_sqrt(x[i]);
  return root;
}

}  // namespace fiberfate::FIBERFATE_ISA
#endif
