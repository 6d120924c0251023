// Computes axis distances and soft contact forces of eight pairs of rods at once.
#include "base/simd.hpp"
#include "packing/rod_repulsion.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

#define FIBERFATE_INLINE static inline __attribute__((always_inline))

FIBERFATE_INLINE Pack load_unaligned(const double* from) {
  typedef double UnalignedPack __attribute__((vector_size(64), aligned(8)));
  return *reinterpret_cast<const UnalignedPack*>(from);
}

struct Column {
  Pack x, y, z;
};

FIBERFATE_INLINE Column operator+(const Column& a, const Column& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
FIBERFATE_INLINE Column operator-(const Column& a, const Column& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
FIBERFATE_INLINE Column operator*(const Pack& f, const Column& a) {
  return {f * a.x, f * a.y, f * a.z};
}
FIBERFATE_INLINE Pack dot(const Column& a, const Column& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Eight rods side by side.
struct Rods {
  Column centre, half;
  Pack radius, firmness;
};

FIBERFATE_INLINE Rods spread(const RodRecord& rod) {
  return {{broadcast(rod.centre[0]), broadcast(rod.centre[1]), broadcast(rod.centre[2])},
          {broadcast(rod.half[0]), broadcast(rod.half[1]), broadcast(rod.half[2])},
          broadcast(rod.radius),
          broadcast(rod.firmness)};
}

/// Loads eight records, moves each by its image and transposes them.
FIBERFATE_INLINE Rods load_rods(const RepulsionInput& in, int at) {
  Pack r[lanes];
  for (int i = 0; i < lanes; ++i)
    r[i] = load(in.records[in.rod[at + i]].centre) + load(in.shifts[in.image[at + i]].shift);
  Pack pair[lanes], quad[lanes];
  for (int i = 0; i < lanes; i += 2) {
    pair[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    pair[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int i = 0; i < lanes; i += 4) {
    for (int k = 0; k < 2; ++k) {
      quad[i + k] = __builtin_shufflevector(pair[i + k], pair[i + k + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      quad[i + k + 2] = __builtin_shufflevector(pair[i + k], pair[i + k + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  // quad[0..3] hold columns (0, 4), (1, 5), (2, 6), (3, 7) of rows 0-3, quad[4..7] those of rows 4-7.
  const Pack c0 = __builtin_shufflevector(quad[0], quad[4], 0, 1, 2, 3, 8, 9, 10, 11);
  const Pack c1 = __builtin_shufflevector(quad[1], quad[5], 0, 1, 2, 3, 8, 9, 10, 11);
  const Pack c2 = __builtin_shufflevector(quad[2], quad[6], 0, 1, 2, 3, 8, 9, 10, 11);
  const Pack c3 = __builtin_shufflevector(quad[3], quad[7], 0, 1, 2, 3, 8, 9, 10, 11);
  const Pack c4 = __builtin_shufflevector(quad[0], quad[4], 4, 5, 6, 7, 12, 13, 14, 15);
  const Pack c5 = __builtin_shufflevector(quad[1], quad[5], 4, 5, 6, 7, 12, 13, 14, 15);
  const Pack c6 = __builtin_shufflevector(quad[2], quad[6], 4, 5, 6, 7, 12, 13, 14, 15);
  const Pack c7 = __builtin_shufflevector(quad[3], quad[7], 4, 5, 6, 7, 12, 13, 14, 15);
  return {{c0, c1, c2}, {c3, c4, c5}, c6, c7};
}

/// Closest points x = centre + s half, s in [-1, 1], of two rods (see fibers/closest_points.hpp).
struct Nearest {
  Pack s, t;
  Column separation;
  Pack distance;
};

FIBERFATE_INLINE Nearest nearest(const Rods& i, const Rods& j) {
  constexpr double parallel_sine_squared = 1e-8;
  constexpr double tiny = 1e-30;
  const Pack zero = broadcast(0.0);
  const Column r = i.centre - j.centre;
  const Pack a = dot(i.half, i.half) + tiny;
  const Pack e = dot(j.half, j.half) + tiny;
  const Pack b = dot(i.half, j.half);
  const Pack c = dot(i.half, r);
  const Pack f = dot(j.half, r);
  const Pack determinant = a * e - b * b;
  const Pack over_a = 1.0 / a;
  const Mask parallel = determinant <= parallel_sine_squared * a * e;
  const Pack lines = (b * f - c * e) / choose(parallel, a * e, determinant);
  const Pack overlap = 0.5 * (clamp((b - c) * over_a, -1, 1) + clamp((zero - b - c) * over_a, -1, 1));
  Nearest n;
  n.s = choose(parallel, overlap, clamp(lines, -1, 1));
  n.t = clamp((b * n.s + f) / e, -1, 1);
  n.s = clamp((b * n.t - c) * over_a, -1, 1);
  n.separation = r + n.s * i.half - n.t * j.half;
  n.distance = square_root(dot(n.separation, n.separation) + tiny);
  return n;
}

FIBERFATE_INLINE double sum(const Pack& p) {
  return ((p[0] + p[1]) + (p[2] + p[3])) + ((p[4] + p[5]) + (p[6] + p[7]));
}

FIBERFATE_INLINE double largest(const Pack& p) {
  double most = p[0];
  for (int k = 1; k < lanes; ++k) most = p[k] > most ? p[k] : most;
  return most;
}

FIBERFATE_INLINE RepulsionLoad repel(const RepulsionInput& in, const RepulsionLaw& law, int rod) {
  const Pack zero = broadcast(0.0);
  const Rods subject = spread(in.records[rod]);
  Column on_begin = {zero, zero, zero}, on_end = {zero, zero, zero};
  Pack overlap = broadcast(-1.0), energy = zero;
  for (int at = in.begin[rod]; at < in.begin[rod + 1]; at += lanes) {
    const Rods other = load_rods(in, at);
    const Nearest n = nearest(subject, other);
    const Pack touching = subject.radius + other.radius;
    const Pack gap = larger(law.swelling * touching + law.reach - n.distance, zero);
    const Pack relative = 1.0 - n.distance / touching;
    const Pack x = law.decay * larger(relative, zero);
    const Pack bearable = law.saturation * smaller(subject.firmness, other.firmness);
    const Pack force = smaller(law.stiffness * gap, bearable * (1.0 + x + 0.5 * x * x)) +
                       law.hardness * larger(law.core * touching - n.distance, zero);
    const Column push = (force / n.distance) * n.separation;
    const Pack weight = 0.5 + 0.5 * n.s;
    on_end = on_end + weight * push;
    on_begin = on_begin + (1.0 - weight) * push;
    overlap = larger(overlap, relative);
    energy = energy + 0.25 * law.stiffness * gap * gap;
  }
  return {{sum(on_begin.x), sum(on_begin.y), sum(on_begin.z)},
          {sum(on_end.x), sum(on_end.y), sum(on_end.z)},
          largest(overlap),
          sum(energy)};
}

}  // namespace

void repel_rods(const RepulsionInput& input, const RepulsionLaw& law, int first, int last,
                RepulsionLoad* loads) {
  for (int rod = first; rod < last; ++rod) loads[rod] = repel(input, law, rod);
}

void measure_distances(const RepulsionInput& input, int subject, int count, double* distances) {
  const Rods rod = spread(input.records[subject]);
  for (int at = 0; at < count; at += lanes) {
    const Nearest n = nearest(rod, load_rods(input, at));
    for (int k = 0; k < lanes; ++k) distances[at + k] = n.distance[k];
  }
}

int search_rods(const CentreArrays& centres, const SearchRod& rod, int first, int last, std::int32_t* near) {
  int found = 0;
  for (int at = first; at < last; at += lanes) {
    const Pack x = load_unaligned(centres.x + at) - rod.centre[0];
    const Pack y = load_unaligned(centres.y + at) - rod.centre[1];
    const Pack z = load_unaligned(centres.z + at) - rod.centre[2];
    const Pack reach = load_unaligned(centres.reach + at);
    const Pack squared = x * x + y * y + z * z;
    const Pack along = x * rod.direction[0] + y * rod.direction[1] + z * rod.direction[2];
    const Pack sphere = reach + rod.sphere;
    const Pack tube = reach + rod.tube;
    const Mask hit = (squared < sphere * sphere) & (squared - along * along < tube * tube);
    const int valid = last - at < lanes ? last - at : lanes;
    for (int k = 0; k < valid; ++k) {
      near[found] = at + k;
      found -= static_cast<int>(hit[k]);
    }
  }
  return found;
}

}  // namespace fiberfate::FIBERFATE_ISA
