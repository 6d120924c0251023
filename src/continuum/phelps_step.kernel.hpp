// Advances the length distributions of eight points by one step of the Phelps-Tucker model (one lane a
// point).
#include "base/simd.hpp"
#include "continuum/phelps_block.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

// Vectors of the register's own width: wider ones are kept in memory by compilers, which costs a factor of
// five here.
#if defined(__AVX512F__)
constexpr std::size_t width = 8;
#elif defined(__AVX__)
constexpr std::size_t width = 4;
#else
constexpr std::size_t width = 2;
#endif
typedef double Vector __attribute__((vector_size(width * sizeof(double))));
constexpr std::size_t stride = lanes;

#define FIBERFATE_INLINE static inline __attribute__((always_inline))

FIBERFATE_INLINE Vector& at(double* data) {
  return *reinterpret_cast<Vector*>(data);
}
FIBERFATE_INLINE const Vector& at(const double* data) {
  return *reinterpret_cast<const Vector*>(data);
}

/// Adds the children that four rows receive from columns `from` and on, sum over k of R_ik broken_k, to `to`.
/// `children` points to the rows' coefficients of column `from`; `broken` and `to` to one lane group.
FIBERFATE_INLINE void receive(const PhelpsBlock& block, const double* children, std::size_t from,
                              const double* broken, double* to) {
  Vector a = {}, b = {}, c = {}, d = {};
  // Even and odd columns are summed apart, so that more sums are under way than an addition takes cycles.
  Vector a2 = {}, b2 = {}, c2 = {}, d2 = {};
  std::size_t k = from;
  for (; k + 1 < block.bins; k += 2, children += 8) {
    const Vector even = at(broken + k * stride);
    const Vector odd = at(broken + (k + 1) * stride);
    a += children[0] * even;
    b += children[1] * even;
    c += children[2] * even;
    d += children[3] * even;
    a2 += children[4] * odd;
    b2 += children[5] * odd;
    c2 += children[6] * odd;
    d2 += children[7] * odd;
  }
  if (k < block.bins) {
    const Vector last = at(broken + k * stride);
    a += children[0] * last;
    b += children[1] * last;
    c += children[2] * last;
    d += children[3] * last;
  }
  at(to) += a + a2;
  at(to + stride) += b + b2;
  at(to + 2 * stride) += c + c2;
  at(to + 3 * stride) += d + d2;
}

/// Adds the present power's part to result and integral, and takes away what breaks next.
FIBERFATE_INLINE void collect(const PhelpsBlock& block, std::size_t j, std::size_t lane) {
  const Vector weight = at(block.weights + j * stride + lane);
  const Vector tail = at(block.tails + j * stride + lane);
  for (std::size_t i = block.first_row * stride + lane; i < block.padded_bins * stride; i += stride) {
    const Vector power = at(block.power + i);
    const Vector broken = at(block.share + i) * power;
    at(block.numbers + i) += weight * power;
    at(block.integral + i) += tail * power;
    at(block.broken + i) = broken;
    at(block.power + i) = power - broken;
  }
}

/// Sums the series in the rows where something breaks.
FIBERFATE_INLINE void sum_series(const PhelpsBlock& block, const double* first_children, std::size_t lane) {
  for (std::size_t i = block.first_row * stride + lane; i < block.padded_bins * stride; i += stride) {
    at(block.power + i) = at(block.numbers + i);
    at(block.numbers + i) = Vector{};
    at(block.integral + i) = Vector{};
  }
  collect(block, 0, lane);
  for (std::size_t j = 1; j <= block.terms; ++j) {
    const double* children = first_children;
    for (std::size_t row = block.first_row; row < block.bins; row += 4) {
      receive(block, children, row + 1, block.broken + lane, block.power + row * stride + lane);
      children += 4 * (block.bins - row - 1);
    }
    collect(block, j, lane);
  }
}

/// Gives the rows below, where nothing breaks, their children of the whole step.
FIBERFATE_INLINE void collect_short_fibers(const PhelpsBlock& block, std::size_t lane) {
  for (std::size_t i = block.first_row * stride + lane; i < block.padded_bins * stride; i += stride)
    at(block.broken + i) = at(block.share + i) * at(block.integral + i);
  const double* children = block.children;
  for (std::size_t row = 0; row < block.first_row; row += 4) {
    receive(block, children + 4 * (block.first_row - row - 1), block.first_row, block.broken + lane,
            block.numbers + row * stride + lane);
    children += 4 * (block.bins - row - 1);
  }
}

}  // namespace

void advance_phelps(const PhelpsBlock& block) {
  const double* first_children = block.children;
  for (std::size_t row = 0; row < block.first_row; row += 4) first_children += 4 * (block.bins - row - 1);
  for (std::size_t lane = 0; lane < stride; lane += width) {
    sum_series(block, first_children, lane);
    collect_short_fibers(block, lane);
  }
}

}  // namespace fiberfate::FIBERFATE_ISA
