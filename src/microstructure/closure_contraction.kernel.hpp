// Contracts the closed A4 of many states with symmetric tensors, eight side by side.
#include "microstructure/closure_block.hpp"
#include "microstructure/closure_pack.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

FIBERFATE_INLINE Symmetric read_symmetric(const double* from) {
  return {load(from),
          load(from + lanes),
          load(from + 2 * lanes),
          load(from + 3 * lanes),
          load(from + 4 * lanes),
          load(from + 5 * lanes)};
}

FIBERFATE_INLINE void write_symmetric(double* to, const Symmetric& a) {
  store(to, a.c11);
  store(to + lanes, a.c22);
  store(to + 2 * lanes, a.c33);
  store(to + 3 * lanes, a.c23);
  store(to + 4 * lanes, a.c31);
  store(to + 5 * lanes, a.c12);
}

}  // namespace

void contract_closures(Closure closure, const ClosureBlock& block) {
  const Symmetric a = read_symmetric(block.second);
  Frame frame{};
  if (needs_frame(closure)) frame = find_frame(a);
  write_symmetric(block.contracted, contract_closure(closure, a, frame, read_symmetric(block.symmetric)));
}

void find_frames(const double* tensors, double* values, double* axes) {
  const Frame frame = find_frame(read_symmetric(tensors));
  for (int k = 0; k < 3; ++k) {
    store(values + k * lanes, frame.value[k]);
    for (int i = 0; i < 3; ++i) store(axes + (3 * k + i) * lanes, frame.axis[k][i]);
  }
}

}  // namespace fiberfate::FIBERFATE_ISA
