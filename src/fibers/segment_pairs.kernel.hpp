// Filters and measures listed pairs of rods; closest_points() is the specification of the distances.
#include "base/simd_rows.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

/// Displacements of the images in which the second rods stand, m.
static inline __attribute__((always_inline)) Triple shifts_of(const SegmentQuery& query, const Index* which) {
  alignas(64) double turns[3][lanes];
  for (int i = 0; i < lanes; ++i) {
    const auto packed = static_cast<std::uint32_t>(query.image[which[i]]);
    for (int d = 0; d < 3; ++d) turns[d][i] = static_cast<std::int8_t>(packed >> (8 * d));
  }
  return transform(query.lattice, {load(turns[0]), load(turns[1]), load(turns[2])});
}

/// Holds eight pairs: r = x1 − x2 from the begin of the second rod to that of the first, u and v along them.
struct PairPack {
  Triple r, u, v;
  alignas(32) Index first[lanes];
  alignas(32) Index second[lanes];
};

static inline __attribute__((always_inline)) void gather_pairs(const SegmentQuery& query, const Index* which,
                                                               PairPack& pairs) {
  const double* begin[lanes];
  const double* other_begin[lanes];
  const double* end[lanes];
  const double* other_end[lanes];
  std::int32_t images = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    const Index pair = which[lane];
    pairs.first[lane] = query.first[pair];
    pairs.second[lane] = query.second[pair];
    begin[lane] = query.position + 3 * static_cast<long>(pairs.first[lane]);
    other_begin[lane] = query.position + 3 * static_cast<long>(pairs.second[lane]);
    end[lane] = begin[lane] + 3;
    other_end[lane] = other_begin[lane] + 3;
    images |= query.image[pair];
  }
  const Triple x = read_triples(begin);
  const Triple y = read_triples(other_begin);
  pairs.u = read_triples(end) - x;
  pairs.v = read_triples(other_end) - y;
  pairs.r = x - y;
  if (images != 0) pairs.r = pairs.r - shifts_of(query, which);
}

}  // namespace

int find_awake_pairs(const Index* first, const Index* second, const float* wake, int count,
                     const float* reach, Index* awake) {
  int found = 0;
  alignas(64) Index numbers[float_lanes];
  for (int i = 0; i < count; i += float_lanes) {
    const Floats together = gather(reach, first + i) + gather(reach, second + i);
    const std::uint32_t bits = to_bits(together >= read_floats(wake + i));
    if (bits == 0) continue;
    for (int lane = 0; lane < float_lanes; ++lane) numbers[lane] = i + lane;
    found += write_selected(awake + found, numbers, bits);
  }
  return found;
}

void find_segment_distances(const SegmentQuery& query, const Index* which, int count, SegmentBlock& block) {
  PairPack pairs;
  for (int i = 0; i < count; i += lanes) {
    gather_pairs(query, which + i, pairs);
    const Triple &r = pairs.r, &u = pairs.u, &v = pairs.v;
    const Pack uu = dot(u, u);
    const Pack vv = dot(v, v);
    const Pack uv = dot(u, v);
    const Pack ur = dot(u, r);
    const Pack vr = dot(v, r);
    const Pack sine2 = uu * vv - uv * uv;
    const Mask parallel = sine2 <= parallel_sine2 * uu * vv;
    const Pack per_uu = 1.0 / uu;

    // Lines that cross at an angle: the optimum of both lines, clamped to the first segment.
    const Pack skew = clamp((uv * vr - ur * vv) / choose(parallel, broadcast(1), sine2), 0, 1);
    // Parallel lines: the middle of the stretch of the first segment that lies alongside the second.
    const Pack at_begin = clamp(-ur * per_uu, 0, 1);
    const Pack at_end = clamp((uv - ur) * per_uu, 0, 1);
    Pack s = choose(parallel, 0.5 * (at_begin + at_end), skew);
    const Pack t = clamp((uv * s + vr) / vv, 0, 1);
    s = choose(parallel, s, clamp((uv * t - ur) * per_uu, 0, 1));

    const Triple apart = r + s * u - t * v;
    store(block.s + i, s);
    store(block.t + i, t);
    store(block.separation[0] + i, apart.x);
    store(block.separation[1] + i, apart.y);
    store(block.separation[2] + i, apart.z);
    const Pack distance = square_root(dot(apart, apart));
    store(block.distance + i, distance);

    const Pack gap = distance - query.range;
    const IndexPack first = read_indices(pairs.first);
    const IndexPack second = read_indices(pairs.second);
    const HalfFloats travel = gather(query.travel, first) + gather(query.travel, second);
    const HalfFloats ahead = gather(query.ahead, first) + gather(query.ahead, second);
    const Pack asleep = clamp(gap, 0, query.widest_gap) * (1 - 1e-6);
    *reinterpret_cast<HalfFloats*>(block.wake + i) = travel + __builtin_convertvector(asleep, HalfFloats);
    const Mask is_near = gap < __builtin_convertvector(ahead, Pack);
    block.near[i / lanes] = static_cast<std::uint8_t>(to_bits(is_near));
  }
}

}  // namespace fiberfate::FIBERFATE_ISA
