// Filters and measures listed pairs of rods; closest_points() is the specification of the distances.
#include "base/simd_rows.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

/// Displacements of the images in which the second rods stand, m.
static inline __attribute__((always_inline)) Triple shifts_of(const SegmentQuery& query, const Index* which) {
  alignas(64) double turns[3][lanes];
  for (int i = 0; i < lanes; ++i) {
    const std::int32_t packed = query.image[which[i]];
    for (int d = 0; d < 3; ++d) turns[d][i] = image_number(packed, d);
  }
  return transform(query.lattice, {load(turns[0]), load(turns[1]), load(turns[2])});
}

/// Eight pairs: r = x1 − x2 from the begin of the second rod to that of the first, u and v along them.
struct PairPack {
  Triple r, u, v;
  const double* begin[lanes];
  const double* other_begin[lanes];
};

static inline __attribute__((always_inline)) void gather_pairs(const SegmentQuery& query, const Index* which,
                                                               SegmentBlock& block, int at, PairPack& pairs) {
  const double* end[lanes];
  const double* other_end[lanes];
  std::int32_t images = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    const Index pair = which[lane];
    block.first[at + lane] = query.first[pair];
    block.second[at + lane] = query.second[pair];
    block.image[at + lane] = query.image[pair];
    pairs.begin[lane] = query.position + 3 * static_cast<long>(query.first[pair]);
    pairs.other_begin[lane] = query.position + 3 * static_cast<long>(query.second[pair]);
    end[lane] = pairs.begin[lane] + 3;
    other_end[lane] = pairs.other_begin[lane] + 3;
    images |= query.image[pair];
  }
  const Triple x = read_triples(pairs.begin);
  const Triple y = read_triples(pairs.other_begin);
  pairs.u = read_triples(end) - x;
  pairs.v = read_triples(other_end) - y;
  pairs.r = x - y;
  if (images != 0) pairs.r = pairs.r - shifts_of(query, which);
}

/// Bits of the pairs whose contact at a rod's end is seen by the rod beyond the hinge as well, and belongs
/// to that one: always at a rod's begin; at a rod's end when the next rod comes nearer. `other` leads to the
/// other rod, `begin` are the rods' first nodes.
static inline __attribute__((always_inline)) std::uint32_t belong_to_neighbour(
    const SegmentQuery& query, const Index* rods, const double* const* begin, const Pack& place,
    const Triple& other, std::uint32_t asked) {
  const Mask is_begin = place <= 0.0;
  const Mask is_end = place >= 1.0;
  const std::uint32_t at_begin = to_bits(is_begin) & asked;
  const std::uint32_t at_end = to_bits(is_end) & asked;
  if ((at_begin | at_end) == 0) return 0;
  const double* end[lanes];
  const double* next[lanes];
  std::uint32_t begins = 0, ends = 0;
  for (int lane = 0; lane < lanes; ++lane) {
    const std::uint32_t part = query.part[rods[lane]];
    begins |= (part & first_of_fiber) << lane;
    ends |= ((part & last_of_fiber) / last_of_fiber) << lane;
    end[lane] = begin[lane] + 3;
    next[lane] = end[lane] + ((part & last_of_fiber) != 0 ? 0 : 3);
  }
  const Mask is_ahead = dot(read_triples(next) - read_triples(end), other) > 0.0;
  return (at_begin & ~begins) | (at_end & ~at_begin & ~ends & to_bits(is_ahead));
}

/// Marks pairs of rods between whose numbers one node lies, so that they may just have broken apart, and
/// those whose axes cross, which have no normal.
static inline __attribute__((always_inline)) std::uint32_t special_pairs(const SegmentBlock& block, int at) {
  const IndexPack between = read_indices(block.second + at) - read_indices(block.first + at) - 2;
  const IndexPack is_own = (between | read_indices(block.image + at)) == 0;
  const Mask is_crossing = load(block.distance + at) <= 0.0;
  return to_bits(is_crossing) | to_bits(__builtin_convertvector(is_own, Mask));
}

}  // namespace

int find_awake_pairs(const Index* first, const Index* second, const std::int32_t* wake, int count,
                     const std::int32_t* reach, Index* awake) {
  int found = 0;
  alignas(64) Index numbers[float_lanes];
  for (int i = 0; i < count; i += float_lanes) {
    const Integers together = gather_integers(reach, first + i) + gather_integers(reach, second + i);
    const std::uint32_t bits = to_bits(together >= read_integers(wake + i));
    if (bits == 0) continue;
    for (int lane = 0; lane < float_lanes; ++lane) numbers[lane] = i + lane;
    found += write_selected(awake + found, numbers, bits);
  }
  return found;
}

void find_segment_distances(const SegmentQuery& query, const Index* which, int count, SegmentBlock& block) {
  PairPack pairs;
  for (int i = 0; i < count; i += lanes) {
    gather_pairs(query, which + i, block, i, pairs);
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
    const IndexPack first = read_indices(block.first + i);
    const IndexPack second = read_indices(block.second + i);
    const IndexPack travel = gather(query.travel, first) + gather(query.travel, second);
    const HalfFloats ahead = gather(query.ahead, first) + gather(query.ahead, second);
    const Pack asleep = clamp(gap, 0, query.widest_gap) * query.per_quantum;
    *reinterpret_cast<IndexPack*>(block.wake + i) = travel + __builtin_convertvector(asleep, IndexPack);
    const Mask is_near = gap < __builtin_convertvector(ahead, Pack);
    std::uint32_t near = to_bits(is_near) & first_bits(count - i);
    near &=
        ~belong_to_neighbour(query, block.first + i, pairs.begin, s, {-apart.x, -apart.y, -apart.z}, near);
    near &= ~belong_to_neighbour(query, block.second + i, pairs.other_begin, t, apart, near);
    block.near[i / lanes] = static_cast<std::uint8_t>(near);
    block.special[i / lanes] = static_cast<std::uint8_t>(special_pairs(block, i));
  }
}

}  // namespace fiberfate::FIBERFATE_ISA
