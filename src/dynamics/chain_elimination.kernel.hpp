// Eliminates the block-banded saddle systems of eight fibers at once (one lane a fiber).
//
// Front of unknowns [w_k, λ_k, w_{k+1}, w_{k+2}]: w_k goes first (its block is positive definite), then λ_k
// (its pivot −pᵀA⁻¹p is negative); no pivoting is needed. Solutions replace `load` (w) and `stretch` (λ).
#include "base/simd.hpp"
#include "dynamics/chain_system.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

#define FIBERFATE_INLINE static inline __attribute__((always_inline))

struct Column {
  Pack x, y, z;
};

struct Symmetric {
  Pack xx, yy, zz, yz, zx, xy;
};

/// Full 3×3 block, by columns.
struct Block {
  Column a, b, c;
};

FIBERFATE_INLINE Pack dot(const Column& a, const Column& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
FIBERFATE_INLINE Column load_column(const double* p) {
  return {load(p), load(p + lanes), load(p + 2 * lanes)};
}
FIBERFATE_INLINE void store_column(double* p, const Column& v) {
  store(p, v.x);
  store(p + lanes, v.y);
  store(p + 2 * lanes, v.z);
}
FIBERFATE_INLINE Symmetric load_symmetric(const double* p) {
  return {load(p),
          load(p + lanes),
          load(p + 2 * lanes),
          load(p + 3 * lanes),
          load(p + 4 * lanes),
          load(p + 5 * lanes)};
}
FIBERFATE_INLINE Block full(const Symmetric& s) {
  return {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
}
FIBERFATE_INLINE Block load_block(const double* p) {
  return {load_column(p), load_column(p + 3 * lanes), load_column(p + 6 * lanes)};
}
FIBERFATE_INLINE Column minus_scaled(const Column& a, const Pack& f, const Column& b) {
  return {a.x - f * b.x, a.y - f * b.y, a.z - f * b.z};
}

/// L D Lᵀ of a positive definite 3×3 block; keeps the reciprocals of D.
struct Factor {
  Pack l10, l20, l21, r0, r1, r2;
};

FIBERFATE_INLINE Factor factorise(const Symmetric& s) {
  Factor f;
  f.r0 = 1.0 / s.xx;
  f.l10 = s.xy * f.r0;
  f.l20 = s.zx * f.r0;
  const Pack d1 = s.yy - f.l10 * s.xy;
  f.r1 = 1.0 / d1;
  const Pack e21 = s.yz - f.l20 * s.xy;
  f.l21 = e21 * f.r1;
  f.r2 = 1.0 / (s.zz - f.l20 * s.zx - f.l21 * e21);
  return f;
}

FIBERFATE_INLINE Column solve(const Factor& f, const Column& b) {
  const Pack y = b.y - f.l10 * b.x;
  const Pack z = (b.z - f.l20 * b.x - f.l21 * y) * f.r2;
  const Pack v = y * f.r1 - f.l21 * z;
  return {b.x * f.r0 - f.l10 * v - f.l20 * z, v, z};
}

/// The inverse of the factored block, which is symmetric.
FIBERFATE_INLINE Symmetric inverse(const Factor& f) {
  const Pack zero = broadcast(0);
  const Pack one = broadcast(1);
  const Column a = solve(f, {one, zero, zero});
  const Column b = solve(f, {zero, one, zero});
  const Column c = solve(f, {zero, zero, one});
  return {a.x, b.y, c.z, c.y, c.x, b.x};
}

/// Subtracts Mᵀ W, which is symmetric: W solves with a symmetric matrix for M.
FIBERFATE_INLINE void subtract_gram(Symmetric& s, const Block& m, const Block& w) {
  s.xx -= dot(m.a, w.a);
  s.yy -= dot(m.b, w.b);
  s.zz -= dot(m.c, w.c);
  s.yz -= dot(m.b, w.c);
  s.zx -= dot(m.a, w.c);
  s.xy -= dot(m.a, w.b);
}

/// Subtracts g hᵀ, h a multiple of g.
FIBERFATE_INLINE void subtract_square(Symmetric& s, const Column& g, const Column& h) {
  s.xx -= g.x * h.x;
  s.yy -= g.y * h.y;
  s.zz -= g.z * h.z;
  s.yz -= g.y * h.z;
  s.zx -= g.x * h.z;
  s.xy -= g.x * h.y;
}

/// Mᵀ v, M by columns.
FIBERFATE_INLINE Column transposed_times(const Block& m, const Column& v) {
  return {dot(m.a, v), dot(m.b, v), dot(m.c, v)};
}

FIBERFATE_INLINE Column minus(const Column& a, const Column& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
FIBERFATE_INLINE Column scaled(const Pack& f, const Column& v) {
  return {f * v.x, f * v.y, f * v.z};
}

/// The unknowns that elimination works on: w_k, w_{k+1}, w_{k+2}, with their loads and couplings.
struct Front {
  Symmetric here, next, third;
  Column here_load, next_load, third_load;
  Block couple;   ///< w_k with w_{k+1}
  Block couple2;  ///< w_{k+1} with w_{k+2}
};

/// What back substitution needs of node k:
///   λ_k = rest − h1·w_{k+1} − h2·w_{k+2},   w_k = wf − w1 w_{k+1} − w2 w_{k+2} − wp λ_k
struct Kept {
  Block w1;
  Symmetric w2;
  Column wp, wf, h1, h2;
  Pack rest;
};

FIBERFATE_INLINE void store_kept(double* f, const Kept& kept) {
  const Column columns[7] = {kept.w1.a, kept.w1.b, kept.w1.c, kept.wp, kept.wf, kept.h1, kept.h2};
  for (int c = 0; c < 7; ++c) store_column(f + 3 * c * lanes, columns[c]);
  const Pack packs[7] = {kept.w2.xx, kept.w2.yy, kept.w2.zz, kept.w2.yz, kept.w2.zx, kept.w2.xy, kept.rest};
  for (int c = 0; c < 7; ++c) store(f + (21 + c) * lanes, packs[c]);
}

FIBERFATE_INLINE Kept load_kept(const double* f) {
  const auto column = [f](int c) { return load_column(f + 3 * c * lanes); };
  return {{column(0), column(1), column(2)},
          load_symmetric(f + 21 * lanes),
          column(3),
          column(4),
          column(5),
          column(6),
          load(f + 27 * lanes)};
}

FIBERFATE_INLINE Front first_front(const double* first, const double* second) {
  Front front;
  front.here = load_symmetric(first + ChainSystem::diagonal * lanes);
  front.here_load = load_column(first + ChainSystem::load * lanes);
  front.couple = load_block(first + ChainSystem::coupling * lanes);
  front.next = load_symmetric(second + ChainSystem::diagonal * lanes);
  front.next_load = load_column(second + ChainSystem::load * lanes);
  return front;
}

/// Takes node k + 2 into the front; where there is none, node k couples with nothing beyond and any record
/// serves.
FIBERFATE_INLINE void take_third(Front& front, const double* second, const double* third) {
  front.couple2 = load_block(second + ChainSystem::coupling * lanes);
  front.third = load_symmetric(third + ChainSystem::diagonal * lanes);
  front.third_load = load_column(third + ChainSystem::load * lanes);
}

/// Eliminates w_k: its Schur complement goes to w_{k+1} and w_{k+2}. `s` couples w_k with w_{k+2}.
FIBERFATE_INLINE void eliminate_velocity(Front& front, const Pack& s, const Column& p, Kept& kept) {
  const Factor factor = factorise(front.here);
  const Block& couple = front.couple;
  kept.w1 = {solve(factor, couple.a), solve(factor, couple.b), solve(factor, couple.c)};
  const Symmetric inv = inverse(factor);
  kept.w2 = {s * inv.xx, s * inv.yy, s * inv.zz, s * inv.yz, s * inv.zx, s * inv.xy};
  kept.wp = solve(factor, {-p.x, -p.y, -p.z});
  kept.wf = solve(factor, front.here_load);

  subtract_gram(front.next, couple, kept.w1);
  const Block w2 = full(kept.w2);
  front.couple2.a = minus(front.couple2.a, transposed_times(couple, w2.a));
  front.couple2.b = minus(front.couple2.b, transposed_times(couple, w2.b));
  front.couple2.c = minus(front.couple2.c, transposed_times(couple, w2.c));
  front.third.xx -= s * kept.w2.xx;
  front.third.yy -= s * kept.w2.yy;
  front.third.zz -= s * kept.w2.zz;
  front.third.yz -= s * kept.w2.yz;
  front.third.zx -= s * kept.w2.zx;
  front.third.xy -= s * kept.w2.xy;
  front.next_load = minus(front.next_load, transposed_times(couple, kept.wf));
  front.third_load = minus_scaled(front.third_load, s, kept.wf);
}

/// Eliminates λ_k: pivot, couplings to w_{k+1} and w_{k+2}, right-hand side.
FIBERFATE_INLINE void eliminate_tension(Front& front, const double* record, const Pack& s, const Column& p,
                                        Kept& kept) {
  const Pack reciprocal = 1.0 / (load(record + ChainSystem::regular * lanes) + dot(p, kept.wp));
  const Pack rest = load(record + ChainSystem::stretch * lanes) + dot(p, kept.wf);
  const Column g1 = minus(p, transposed_times(front.couple, kept.wp));
  const Column g2 = scaled(-s, kept.wp);
  kept.h1 = scaled(reciprocal, g1);
  kept.h2 = scaled(reciprocal, g2);
  kept.rest = rest * reciprocal;
  subtract_square(front.next, g1, kept.h1);
  subtract_square(front.third, g2, kept.h2);
  front.couple2.a = minus_scaled(front.couple2.a, kept.h2.x, g1);
  front.couple2.b = minus_scaled(front.couple2.b, kept.h2.y, g1);
  front.couple2.c = minus_scaled(front.couple2.c, kept.h2.z, g1);
  front.next_load = minus_scaled(front.next_load, rest, kept.h1);
  front.third_load = minus_scaled(front.third_load, rest, kept.h2);
}

FIBERFATE_INLINE void advance_front(Front& front) {
  front.here = front.next;
  front.here_load = front.next_load;
  front.next = front.third;
  front.next_load = front.third_load;
  front.couple = front.couple2;
}

/// Subtracts M v from a column, M by columns.
FIBERFATE_INLINE Column minus_product(const Column& a, const Block& m, const Column& v) {
  return minus_scaled(minus_scaled(minus_scaled(a, v.x, m.a), v.y, m.b), v.z, m.c);
}

}  // namespace

/// Solves the systems of `nodes` nodes each (at least 2).
void eliminate_chains(double* records, double* factors, int nodes) {
  const auto record = [=](int k) { return records + static_cast<long>(k) * ChainSystem::size * lanes; };
  const auto kept_at = [=](int k) { return factors + static_cast<long>(k) * ChainSystem::kept * lanes; };

  Front front = first_front(record(0), record(1));
  for (int k = 0; k + 1 < nodes; ++k) {
    take_third(front, record(k + 1), record(k + 2 < nodes ? k + 2 : k + 1));
    const Pack s = load(record(k) + ChainSystem::second * lanes);
    const Column p = load_column(record(k) + ChainSystem::direction * lanes);
    Kept kept;
    eliminate_velocity(front, s, p, kept);
    eliminate_tension(front, record(k), s, p, kept);
    store_kept(kept_at(k), kept);
    advance_front(front);
  }

  Column w = solve(factorise(front.here), front.here_load);
  Column beyond = {broadcast(0), broadcast(0), broadcast(0)};
  store_column(record(nodes - 1) + ChainSystem::load * lanes, w);
  for (int k = nodes - 2; k >= 0; --k) {
    const Kept kept = load_kept(kept_at(k));
    const Pack tension = kept.rest - dot(kept.h1, w) - dot(kept.h2, beyond);
    const Column v = minus_product(minus_product(minus_scaled(kept.wf, tension, kept.wp), kept.w1, w),
                                   full(kept.w2), beyond);
    store_column(record(k) + ChainSystem::load * lanes, v);
    store(record(k) + ChainSystem::stretch * lanes, tension);
    beyond = w;
    w = v;
  }
}

#undef FIBERFATE_INLINE

}  // namespace fiberfate::FIBERFATE_ISA
