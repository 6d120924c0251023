// Adds pair forces to the records of eight fibers: the k-th rods of all eight at a time.
#include "base/simd_rows.hpp"
#include "dynamics/chain_assembly.hpp"
#include "dynamics/chain_system.hpp"
#include "dynamics/pair_loads.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

#define FIBERFATE_INLINE static inline __attribute__((always_inline))

/// The records of a rod's two nodes.
struct Records {
  double* near;
  double* far;
};

/// Eight rods and the velocities about which forces are linearised.
struct Rods {
  Pack inverse_length;
  Triple p, velocity, change;
};

/// The shares of one slot: force on the rod at rest, sign + on a force's first rod.
struct Shares {
  Triple force, normal;
  Pack sign, place, distance, along, across;
};

FIBERFATE_INLINE Rods read_rods(const PairLoadQuery& query, const ChainGroup& group, int k) {
  const double* x[lanes];
  const double* next_x[lanes];
  const double* w[lanes];
  const double* next_w[lanes];
  for (int lane = 0; lane < lanes; ++lane) {
    const int last = group.rods[lane] - 1;
    const long rod = group.first[lane] + (k < last ? k : last);
    x[lane] = query.position + 3 * rod;
    next_x[lane] = x[lane] + 3;
    w[lane] = query.velocity + 3 * rod;
    next_w[lane] = w[lane] + 3;
  }
  const Pack inverse = 1.0 / load(query.numbers + offset_of(RodNumber::length, k));
  const Triple velocity = read_triples(w);
  return {inverse, inverse * (read_triples(next_x) - read_triples(x)), velocity,
          read_triples(next_w) - velocity};
}

// Stands where a fiber has no share in a slot.
alignas(64) constexpr PairForce no_force = {};

FIBERFATE_INLINE Shares read_shares(const PairLoadQuery& query, const Index* numbers) {
  const double* force[lanes];
  const double* normal[lanes];
  const double* places[lanes];
  const double* held[lanes];
  for (int lane = 0; lane < lanes; ++lane) {
    const PairForce& from = numbers[lane] < 0 ? no_force : query.forces[numbers[lane] / 2];
    force[lane] = from.force;
    normal[lane] = from.normal;
    places[lane] = &from.s;
    held[lane] = &from.distance;
  }
  const Mask is_second = __builtin_convertvector(read_indices(numbers) & 1, Mask) != 0;
  const Triple at = read_triples(places);
  const Triple resistance = read_triples(held);  // distance, along, across
  return {read_triples(force),
          read_triples(normal),
          choose(is_second, broadcast(-1), broadcast(1)),
          choose(is_second, at.y, at.x),
          at.z,
          resistance.y,
          resistance.z};
}

FIBERFATE_INLINE void add(double* record, int component, const Pack& value) {
  double* to = record + component * lanes;
  store(to, load(to) + value);
}

FIBERFATE_INLINE void add(double* record, int component, const Triple& value) {
  add(record, component, value.x);
  add(record, component + 1, value.y);
  add(record, component + 2, value.z);
}

FIBERFATE_INLINE void add_blocks(const Records& to, const Shares& share, const Triple& direction,
                                 const Pack& cosine, const Pack& turn) {
  const Pack p[3] = {direction.x, direction.y, direction.z};
  const Pack n[3] = {share.normal.x, share.normal.y, share.normal.z};
  const Pack far = share.place;
  const Pack near = 1.0 - far;
  const Pack excess = share.along - share.across;
  const int rows[6] = {0, 1, 2, 1, 2, 0};
  const int columns[6] = {0, 1, 2, 2, 0, 1};
  for (int i = 0; i < 6; ++i) {
    const int r = rows[i], c = columns[i];
    const Pack one = broadcast(r == c ? 1 : 0);
    const Pack nn = n[r] * n[c];
    const Pack both = p[r] * n[c] + n[r] * p[c];
    const Pack held = share.across * one + excess * nn;
    const Pack turning = turn * (both - 2.0 * cosine * one);
    const Pack squared = turn * turn * (nn - cosine * both + cosine * cosine * one);
    add(to.near, ChainSystem::diagonal + i, near * near * held + share.across * (squared - near * turning));
    add(to.far, ChainSystem::diagonal + i, far * far * held + share.across * (squared + far * turning));
    const Pack even = near * far * held - share.across * squared;
    const Pack odd = share.across * turn;
    const Pack diagonal = cosine * one;
    add(to.near, ChainSystem::coupling + 3 * c + r,
        even + odd * (near * (p[r] * n[c] - diagonal) - far * (n[r] * p[c] - diagonal)));
    if (r != c)
      add(to.near, ChainSystem::coupling + 3 * r + c,
          even + odd * (near * (p[c] * n[r]) - far * (n[c] * p[r])));
  }
}

FIBERFATE_INLINE void add_share(const Records& to, const Rods& rods, const Shares& share) {
  const Triple& n = share.normal;
  const Pack far = share.place;
  const Pack cosine = dot(n, rods.p);
  const Pack turn = share.sign * (0.5 * share.distance) * rods.inverse_length;
  const Triple old =
      rods.velocity + far * rods.change + turn * (dot(n, rods.change) * rods.p - cosine * rods.change);
  const Triple force =
      share.sign * share.force + share.across * old + ((share.along - share.across) * dot(n, old)) * n;
  const Triple couple = turn * (dot(rods.p, force) * n - cosine * force);
  add(to.near, ChainSystem::load, (1.0 - far) * force - couple);
  add(to.far, ChainSystem::load, far * force + couple);
  add_blocks(to, share, rods.p, cosine, turn);
}

}  // namespace

void add_pair_loads(const PairLoadQuery& query, const ChainGroup& group) {
  int slot = 0;
  for (int k = 0; k < query.rods; ++k) {
    if (slot == query.slot_ends[k]) continue;
    const Rods rods = read_rods(query, group, k);
    double* record = query.records + static_cast<long>(k) * ChainSystem::size * lanes;
    const Records to{record, record + ChainSystem::size * lanes};
    for (; slot < query.slot_ends[k]; ++slot)
      add_share(to, rods, read_shares(query, query.slot_numbers + static_cast<long>(slot) * lanes));
  }
}

#undef FIBERFATE_INLINE

}  // namespace fiberfate::FIBERFATE_ISA
