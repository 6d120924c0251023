// Decomposes eight symmetric tensors side by side with Jacobi rotations; only kernels include it.
#pragma once

#include "microstructure/symmetric_pack.hpp"

#ifdef FIBERFATE_ISA
namespace fiberfate::FIBERFATE_ISA {

/// As equal_principal_values of eigenframe.hpp, which pulls in Eigen and so cannot be included here.
inline constexpr double equal_values = 1e-9;
/// Sweeps after which Jacobi's method has converged quadratically for every 3×3 tensor (4 or 5 are the rule).
inline constexpr int most_sweeps = 12;

/// Principal values in falling order and their axes: axis[k][i] is the component i of axis k.
struct Frame {
  Pack value[3];
  Pack axis[3][3];
};

/// For the pairs (1,2), (2,3), (3,1) of eight frames, whether their values are equal.
struct EqualPairs {
  Mask p12, p23, p31;
};

FIBERFATE_INLINE bool any(const Mask& mask) {
  std::int64_t all = 0;
  for (int i = 0; i < lanes; ++i) all |= mask[i];
  return all != 0;
}

FIBERFATE_INLINE Pack magnitude(const Pack& x) {
  return x < 0.0 ? -x : x;
}

/// M · X · Mᵀ with the rows of M.
FIBERFATE_INLINE Symmetric turned(const Pack (&row)[3][3], const Symmetric& x) {
  Pack t[3][3];  // X · Mᵀ
  for (int k = 0; k < 3; ++k) {
    t[0][k] = x.c11 * row[k][0] + x.c12 * row[k][1] + x.c31 * row[k][2];
    t[1][k] = x.c12 * row[k][0] + x.c22 * row[k][1] + x.c23 * row[k][2];
    t[2][k] = x.c31 * row[k][0] + x.c23 * row[k][1] + x.c33 * row[k][2];
  }
  return {row[0][0] * t[0][0] + row[0][1] * t[1][0] + row[0][2] * t[2][0],
          row[1][0] * t[0][1] + row[1][1] * t[1][1] + row[1][2] * t[2][1],
          row[2][0] * t[0][2] + row[2][1] * t[1][2] + row[2][2] * t[2][2],
          row[1][0] * t[0][2] + row[1][1] * t[1][2] + row[1][2] * t[2][2],
          row[2][0] * t[0][0] + row[2][1] * t[1][0] + row[2][2] * t[2][0],
          row[0][0] * t[0][1] + row[0][1] * t[1][1] + row[0][2] * t[2][1]};
}

/// Expresses a tensor in the frame: Rᵀ · X · R.
FIBERFATE_INLINE Symmetric into_frame(const Frame& frame, const Symmetric& x) {
  return turned(frame.axis, x);
}

/// Expresses a tensor of the frame in the fixed axes: R · X · Rᵀ.
FIBERFATE_INLINE Symmetric out_of_frame(const Frame& frame, const Symmetric& x) {
  Pack row[3][3];
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) row[i][k] = frame.axis[k][i];
  return turned(row, x);
}

/// Turns axes p and q so that the component pq vanishes where `wanted`; r is the third index. Golub and Van
/// Loan, Matrix Computations (2013), 8.5: the smaller root of t² + 2 t cot(2 phi) - 1 = 0 keeps the rotation
/// stable.
FIBERFATE_INLINE void rotate_pair(Pack& pp, Pack& qq, Pack& pq, Pack& rp, Pack& rq, Pack (&axis_p)[3],
                                  Pack (&axis_q)[3], const Mask& wanted) {
  const Pack difference = qq - pp;
  const Pack twice = pq + pq;
  const Pack span = magnitude(difference) + square_root(difference * difference + twice * twice);
  const Pack signed_twice = difference < 0.0 ? -twice : twice;
  const Pack tangent =
      (wanted & (span > 0.0)) ? signed_twice / (span > 0.0 ? span : broadcast(1)) : broadcast(0);
  const Pack cosine = 1.0 / square_root(1.0 + tangent * tangent);
  const Pack sine = tangent * cosine;
  pp = pp - tangent * pq;
  qq = qq + tangent * pq;
  pq = wanted ? broadcast(0) : pq;
  const Pack old_rp = rp;
  rp = cosine * old_rp - sine * rq;
  rq = sine * old_rp + cosine * rq;
  for (int i = 0; i < 3; ++i) {
    const Pack old = axis_p[i];
    axis_p[i] = cosine * old - sine * axis_q[i];
    axis_q[i] = sine * old + cosine * axis_q[i];
  }
}

/// Diagonalises x where pairs are wanted, turning the axes along.
FIBERFATE_OUT_OF_LINE void diagonalise(Symmetric& x, Pack (&axis)[3][3], const EqualPairs& wanted) {
  const Pack scale = magnitude(x.c11) + magnitude(x.c22) + magnitude(x.c33) + magnitude(x.c23) +
                     magnitude(x.c31) + magnitude(x.c12);
  const Pack small = 1e-17 * scale;  // turns axes by no more than round-off does
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    rotate_pair(x.c11, x.c22, x.c12, x.c31, x.c23, axis[0], axis[1], wanted.p12);
    rotate_pair(x.c22, x.c33, x.c23, x.c12, x.c31, axis[1], axis[2], wanted.p23);
    rotate_pair(x.c33, x.c11, x.c31, x.c23, x.c12, axis[2], axis[0], wanted.p31);
    const Mask open = ((magnitude(x.c12) > small) & wanted.p12) | ((magnitude(x.c23) > small) & wanted.p23) |
                      ((magnitude(x.c31) > small) & wanted.p31);
    if (!any(open)) return;
  }
}

FIBERFATE_INLINE void order_pair(Pack& higher, Pack& lower, Pack (&axis_higher)[3], Pack (&axis_lower)[3],
                                 const Mask& allowed) {
  const Mask swap = allowed & (lower > higher);
  const Pack value = higher;
  higher = choose(swap, lower, higher);
  lower = choose(swap, value, lower);
  for (int i = 0; i < 3; ++i) {
    const Pack component = axis_higher[i];
    axis_higher[i] = choose(swap, axis_lower[i], axis_higher[i]);
    axis_lower[i] = choose(swap, -component, axis_lower[i]);  // the sign keeps the frame a rotation
  }
}

FIBERFATE_OUT_OF_LINE Frame find_frame(const Symmetric& tensor) {
  Frame frame;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) frame.axis[k][i] = broadcast(i == k ? 1 : 0);
  Symmetric x = tensor;
  const Mask all = x.c11 == x.c11;
  diagonalise(x, frame.axis, {all, all, all});
  frame.value[0] = x.c11;
  frame.value[1] = x.c22;
  frame.value[2] = x.c33;
  order_pair(frame.value[0], frame.value[1], frame.axis[0], frame.axis[1], all);
  order_pair(frame.value[1], frame.value[2], frame.axis[1], frame.axis[2], all);
  order_pair(frame.value[0], frame.value[1], frame.axis[0], frame.axis[1], all);
  return frame;
}

FIBERFATE_INLINE EqualPairs equal_pairs(const Pack (&value)[3], const Pack& tolerance) {
  const Mask first = (value[0] - value[1]) < tolerance;
  const Mask last = (value[1] - value[2]) < tolerance;
  return {first, last, first & last};
}

/// Turns axes of equal values so that `guide` is diagonal in their space, in falling order; the rest stays.
/// Returns the diagonal of the guide in the new frame in `guided`.
FIBERFATE_OUT_OF_LINE Frame guided_frame(const Frame& frame, const Symmetric& guide, Pack (&guided)[3]) {
  Frame turned_frame = frame;
  Symmetric x = into_frame(frame, guide);
  const EqualPairs equal = equal_pairs(frame.value, broadcast(equal_values));
  if (any(equal.p12 | equal.p23)) {
    // What couples equal and unequal values must not enter the rotations.
    x.c12 = choose(equal.p12, x.c12, broadcast(0));
    x.c23 = choose(equal.p23, x.c23, broadcast(0));
    x.c31 = choose(equal.p31, x.c31, broadcast(0));
    diagonalise(x, turned_frame.axis, equal);
    order_pair(x.c11, x.c22, turned_frame.axis[0], turned_frame.axis[1], equal.p12);
    order_pair(x.c22, x.c33, turned_frame.axis[1], turned_frame.axis[2], equal.p23);
    order_pair(x.c11, x.c22, turned_frame.axis[0], turned_frame.axis[1], equal.p12);
  }
  guided[0] = x.c11;
  guided[1] = x.c22;
  guided[2] = x.c33;
  return turned_frame;
}

}  // namespace fiberfate::FIBERFATE_ISA
#endif
