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

FIBERFATE_INLINE void subtract_gram(Symmetric& s, const Block& m, const Block& w) {
  s.xx -= dot(m.a, w.a);
  s.yy -= dot(m.b, w.b);
  s.zz -= dot(m.c, w.c);
  s.yz -= dot(m.b, w.c);
  s.zx -= dot(m.a, w.c);
  s.xy -= dot(m.a, w.b);
}

FIBERFATE_INLINE void subtract_square(Symmetric& s, const Column& g, const Column& h) {
  s.xx -= g.x * h.x;
  s.yy -= g.y * h.y;
  s.zz -= g.z * h.z;
  s.yz -= g.y * h.z;
  s.zx -= g.x * h.z;
  s.xy -= g.x * h.y;
}

/// Subtracts Mᵀ (f S) from a full block by columns, S symmetric.
FIBERFATE_INLINE Column transposed_times(const Block& m, const Column& v) {
  return {dot(m.a, v), dot(m.b, v), dot(m.c, v)};
}

}  // namespace

/// Solves the systems of `nodes` nodes each (at least 2).
void eliminate_chains(double* records, double* factors, int nodes) {
  constexpr int size = ChainSystem::size;
  const auto record = [&](int k) { return records + static_cast<long>(k) * size * lanes; };
  const auto kept = [&](int k) { return factors + static_cast<long>(k) * ChainSystem::kept * lanes; };
  const Pack zero = broadcast(0);

  Symmetric here = load_symmetric(record(0) + ChainSystem::diagonal * lanes);
  Column here_load = load_column(record(0) + ChainSystem::load * lanes);
  Block couple = full(load_symmetric(record(0) + ChainSystem::coupling * lanes));
  Symmetric next = load_symmetric(record(1) + ChainSystem::diagonal * lanes);
  Column next_load = load_column(record(1) + ChainSystem::load * lanes);

  for (int k = 0; k + 1 < nodes; ++k) {
    const double* r = record(k);
    const bool has_third = k + 2 < nodes;
    const double* r1 = record(k + 1);
    const double* r2 = record(has_third ? k + 2 : k + 1);
    const Pack s = load(r + ChainSystem::second * lanes);
    const Column p = load_column(r + ChainSystem::direction * lanes);

    const Factor factor = factorise(here);
    const Block w1 = {solve(factor, couple.a), solve(factor, couple.b), solve(factor, couple.c)};
    const Symmetric inv = inverse(factor);
    const Symmetric w2 = {s * inv.xx, s * inv.yy, s * inv.zz, s * inv.yz, s * inv.zx, s * inv.xy};
    const Column minus_p = {-p.x, -p.y, -p.z};
    const Column wp = solve(factor, minus_p);
    const Column wf = solve(factor, here_load);

    // Schur complement of w_k.
    subtract_gram(next, couple, w1);
    const Block w2_full = full(w2);
    Block couple2 = full(load_symmetric(r1 + ChainSystem::coupling * lanes));
    if (!has_third) couple2 = {{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
    const auto minus = [](const Column& a, const Column& b) {
      return Column{a.x - b.x, a.y - b.y, a.z - b.z};
    };
    couple2.a = minus(couple2.a, transposed_times(couple, w2_full.a));
    couple2.b = minus(couple2.b, transposed_times(couple, w2_full.b));
    couple2.c = minus(couple2.c, transposed_times(couple, w2_full.c));
    Symmetric third = load_symmetric(r2 + ChainSystem::diagonal * lanes);
    Column third_load = load_column(r2 + ChainSystem::load * lanes);
    third.xx -= s * w2.xx;
    third.yy -= s * w2.yy;
    third.zz -= s * w2.zz;
    third.yz -= s * w2.yz;
    third.zx -= s * w2.zx;
    third.xy -= s * w2.xy;
    next_load = minus(next_load, transposed_times(couple, wf));
    third_load = minus_scaled(third_load, s, wf);

    // λ_k: pivot, couplings to w_{k+1} and w_{k+2}, right-hand side.
    const Pack pivot = load(r + ChainSystem::regular * lanes) - dot(minus_p, wp);
    const Pack reciprocal = 1.0 / pivot;
    const Column g1 = {p.x - dot(couple.a, wp), p.y - dot(couple.b, wp), p.z - dot(couple.c, wp)};
    const Column g2 = {-s * wp.x, -s * wp.y, -s * wp.z};
    const Pack rest = load(r + ChainSystem::stretch * lanes) - dot(minus_p, wf);
    const Column h1 = {g1.x * reciprocal, g1.y * reciprocal, g1.z * reciprocal};
    const Column h2 = {g2.x * reciprocal, g2.y * reciprocal, g2.z * reciprocal};
    subtract_square(next, g1, h1);
    subtract_square(third, g2, h2);
    couple2.a = minus_scaled(couple2.a, h2.x, g1);
    couple2.b = minus_scaled(couple2.b, h2.y, g1);
    couple2.c = minus_scaled(couple2.c, h2.z, g1);
    next_load = minus_scaled(next_load, rest, h1);
    third_load = minus_scaled(third_load, rest, h2);

    double* f = kept(k);
    store_column(f, w1.a);
    store_column(f + 3 * lanes, w1.b);
    store_column(f + 6 * lanes, w1.c);
    store(f + 9 * lanes, w2.xx);
    store(f + 10 * lanes, w2.yy);
    store(f + 11 * lanes, w2.zz);
    store(f + 12 * lanes, w2.yz);
    store(f + 13 * lanes, w2.zx);
    store(f + 14 * lanes, w2.xy);
    store_column(f + 15 * lanes, wp);
    store_column(f + 18 * lanes, wf);
    store_column(f + 21 * lanes, h1);
    store_column(f + 24 * lanes, h2);
    store(f + 27 * lanes, rest * reciprocal);

    here = next;
    here_load = next_load;
    next = third;
    next_load = third_load;
    couple = couple2;
  }

  Column w = solve(factorise(here), here_load);
  store_column(record(nodes - 1) + ChainSystem::load * lanes, w);
  Column beyond = {zero, zero, zero};
  for (int k = nodes - 2; k >= 0; --k) {
    const double* f = kept(k);
    const Column h1 = load_column(f + 21 * lanes);
    const Column h2 = load_column(f + 24 * lanes);
    const Pack tension = load(f + 27 * lanes) - dot(h1, w) - dot(h2, beyond);
    const Block w1 = {load_column(f), load_column(f + 3 * lanes), load_column(f + 6 * lanes)};
    const Block w2 = full(load_symmetric(f + 9 * lanes));
    const Column wp = load_column(f + 15 * lanes);
    Column v = minus_scaled(load_column(f + 18 * lanes), tension, wp);
    v = minus_scaled(minus_scaled(minus_scaled(v, w.x, w1.a), w.y, w1.b), w.z, w1.c);
    v = minus_scaled(minus_scaled(minus_scaled(v, beyond.x, w2.a), beyond.y, w2.b), beyond.z, w2.c);
    store_column(record(k) + ChainSystem::load * lanes, v);
    store(record(k) + ChainSystem::stretch * lanes, tension);
    beyond = w;
    w = v;
  }
}

#undef FIBERFATE_INLINE

}  // namespace fiberfate::FIBERFATE_ISA
