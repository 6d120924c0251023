// Advances the length distributions of eight points by one step of the Phelps-Tucker model (one lane a
// point).
#include "base/simd.hpp"
#include "continuum/phelps_block.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

struct FourRows {
  Pack a, b, c, d;
};

/// Children that four rows receive from columns `from` and on: sum over k of R_ik broken_k. `children` points
/// to the rows' coefficients of column `from`.
static inline __attribute__((always_inline)) FourRows receive(const PhelpsBlock& block,
                                                              const double* children, std::size_t from) {
  FourRows sum = {broadcast(0), broadcast(0), broadcast(0), broadcast(0)};
  for (std::size_t k = from; k < block.bins; ++k, children += 4) {
    const Pack parents = load(block.broken + k * lanes);
    sum.a += children[0] * parents;
    sum.b += children[1] * parents;
    sum.c += children[2] * parents;
    sum.d += children[3] * parents;
  }
  return sum;
}

static inline __attribute__((always_inline)) void add_to(double* to, const Pack& pack) {
  store(to, load(to) + pack);
}

/// Adds the present power's part to result and integral, and finds what breaks next.
static inline __attribute__((always_inline)) void collect(const PhelpsBlock& block, std::size_t j) {
  const Pack weight = load(block.weights + j * lanes);
  const Pack tail = load(block.tails + j * lanes);
  for (std::size_t i = block.first_row; i < block.padded_bins; ++i) {
    const Pack power = load(block.power + i * lanes);
    add_to(block.numbers + i * lanes, weight * power);
    add_to(block.integral + i * lanes, tail * power);
    store(block.broken + i * lanes, load(block.share + i * lanes) * power);
  }
}

/// Replaces the power v by (I + R P/Q) v in four rows.
static inline __attribute__((always_inline)) void raise(const PhelpsBlock& block, const double* children,
                                                        std::size_t row) {
  const FourRows received = receive(block, children, row + 1);
  double* power = block.power + row * lanes;
  const double* broken = block.broken + row * lanes;
  store(power, load(power) - load(broken) + received.a);
  store(power + lanes, load(power + lanes) - load(broken + lanes) + received.b);
  store(power + 2 * lanes, load(power + 2 * lanes) - load(broken + 2 * lanes) + received.c);
  store(power + 3 * lanes, load(power + 3 * lanes) - load(broken + 3 * lanes) + received.d);
}

}  // namespace

void advance_phelps(const PhelpsBlock& block) {
  const double* first_children = block.children;
  for (std::size_t row = 0; row < block.first_row; row += 4) first_children += 4 * (block.bins - row - 1);
  for (std::size_t i = block.first_row; i < block.padded_bins; ++i) {
    store(block.power + i * lanes, load(block.numbers + i * lanes));
    store(block.numbers + i * lanes, broadcast(0));
    store(block.integral + i * lanes, broadcast(0));
  }
  collect(block, 0);
  for (std::size_t j = 1; j <= block.terms; ++j) {
    const double* children = first_children;
    for (std::size_t row = block.first_row; row < block.bins; row += 4) {
      raise(block, children, row);
      children += 4 * (block.bins - row - 1);
    }
    collect(block, j);
  }
  for (std::size_t i = block.first_row; i < block.padded_bins; ++i)
    store(block.broken + i * lanes, load(block.share + i * lanes) * load(block.integral + i * lanes));
  const double* children = block.children;
  for (std::size_t row = 0; row < block.first_row; row += 4) {
    const FourRows received = receive(block, children + 4 * (block.first_row - row - 1), block.first_row);
    double* numbers = block.numbers + row * lanes;
    add_to(numbers, received.a);
    add_to(numbers + lanes, received.b);
    add_to(numbers + 2 * lanes, received.c);
    add_to(numbers + 3 * lanes, received.d);
    children += 4 * (block.bins - row - 1);
  }
}

}  // namespace fiberfate::FIBERFATE_ISA
