// Culls sixteen rods at a time in single precision.
#include "base/simd.hpp"
#include "fibers/rod_cull.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

struct FloatTriple {
  Floats x, y, z;
};

/// Carries vectors of the grid with the fluid.
static inline __attribute__((always_inline)) FloatTriple carried(const RodCull& query, const Floats& x,
                                                                 const Floats& y, const Floats& z) {
  const auto& f = query.fluid;
  return {f[0][0] * x + f[0][1] * y + f[0][2] * z, f[1][0] * x + f[1][1] * y + f[1][2] * z,
          f[2][0] * x + f[2][1] * y + f[2][2] * z};
}

}  // namespace

int cull_rods(const RodCull& query, const EntryRun* runs, int count, Index* found) {
  const Floats half = Floats{} + query.half_length;
  int kept = 0;
  alignas(64) Index numbers[float_lanes];
  for (const EntryRun* run = runs; run < runs + count; ++run) {
    for (Index first = run->begin; first < run->end; first += float_lanes) {
      const FloatTriple d = carried(query, read_floats(query.midpoint_x + first) - query.x,
                                    read_floats(query.midpoint_y + first) - query.y,
                                    read_floats(query.midpoint_z + first) - query.z);
      const Floats place = clamp(d.x * query.ax + d.y * query.ay + d.z * query.az, -half, half);
      const Floats ex = d.x - place * query.ax;
      const Floats ey = d.y - place * query.ay;
      const Floats ez = d.z - place * query.az;
      const Floats reach = read_floats(query.half_lengths + first) * query.stretch +
                           read_floats(query.margins + first) + query.keep;
      const std::uint32_t bits =
          to_bits(ex * ex + ey * ey + ez * ez <= reach * reach) & first_bits(run->end - first);
      if (bits == 0) continue;
      for (int lane = 0; lane < float_lanes; ++lane) numbers[lane] = first + lane;
      kept += write_selected(found + kept, numbers, bits);
    }
  }
  return kept;
}

int keep_near_rods(const RodCull& query, Index* entries, int count, Index* found, float* squared_distance) {
  const Floats half = Floats{} + query.half_length;
  const Floats one = Floats{} + 1.0F;
  for (int lane = count; lane % float_lanes != 0; ++lane) entries[lane] = entries[0];
  int kept = 0;
  for (int i = 0; i < count; i += float_lanes) {
    const Index* at = entries + i;
    const FloatTriple d =
        carried(query, gather(query.midpoint_x, at) - query.x, gather(query.midpoint_y, at) - query.y,
                gather(query.midpoint_z, at) - query.z);
    const FloatTriple axis =
        carried(query, gather(query.axis_x, at), gather(query.axis_y, at), gather(query.axis_z, at));
    const Floats stretch = square_root(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z);
    const Floats bx = axis.x / stretch;
    const Floats by = axis.y / stretch;
    const Floats bz = axis.z / stretch;
    const Floats other_half = gather(query.half_lengths, at) * stretch;
    const Floats reach = gather(query.margins, at) + query.keep;
    // Places s, t from the midpoints: the optimum of both lines clamped, then t for that s, then s for that
    // t. Where the rods are parallel any s will do.
    const Floats cosine = bx * query.ax + by * query.ay + bz * query.az;
    const Floats along = d.x * query.ax + d.y * query.ay + d.z * query.az;
    const Floats other_along = d.x * bx + d.y * by + d.z * bz;
    const Floats sine2 = one - cosine * cosine;
    const Floats divisor = sine2 > 1e-6F ? sine2 : one;
    Floats s = clamp((along - cosine * other_along) / divisor, -half, half);
    const Floats t = clamp(cosine * s - other_along, -other_half, other_half);
    s = clamp(cosine * t + along, -half, half);
    const Floats ex = d.x + t * bx - s * query.ax;
    const Floats ey = d.y + t * by - s * query.ay;
    const Floats ez = d.z + t * bz - s * query.az;
    const Floats squared = ex * ex + ey * ey + ez * ez;
    std::uint32_t bits = to_bits(squared <= reach * reach) & first_bits(count - i);
    for (; bits != 0; bits &= bits - 1) {
      const int lane = __builtin_ctz(bits);
      found[kept] = at[lane];
      squared_distance[kept++] = squared[lane];
    }
  }
  return kept;
}

}  // namespace fiberfate::FIBERFATE_ISA
