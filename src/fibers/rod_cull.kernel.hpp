// Culls sixteen rods at a time in single precision.
#include "base/simd.hpp"
#include "fibers/rod_cull.hpp"

namespace fiberfate::FIBERFATE_ISA {

int cull_rods(const RodCull& query, Index begin, Index end, Index* found) {
  const Floats half = Floats{} + query.half_length;
  int count = 0;
  alignas(64) Index numbers[float_lanes];
  for (Index first = begin; first < end; first += float_lanes) {
    const Floats dx = read_floats(query.midpoint_x + first) - query.x;
    const Floats dy = read_floats(query.midpoint_y + first) - query.y;
    const Floats dz = read_floats(query.midpoint_z + first) - query.z;
    const Floats place = clamp(dx * query.ax + dy * query.ay + dz * query.az, -half, half);
    const Floats ex = dx - place * query.ax;
    const Floats ey = dy - place * query.ay;
    const Floats ez = dz - place * query.az;
    const Floats reach =
        read_floats(query.half_lengths + first) + read_floats(query.margins + first) + query.keep;
    const std::uint32_t bits =
        to_bits(ex * ex + ey * ey + ez * ez <= reach * reach) & first_bits(end - first);
    if (bits == 0) continue;
    for (int lane = 0; lane < float_lanes; ++lane) numbers[lane] = first + lane;
    count += write_selected(found + count, numbers, bits);
  }
  return count;
}

int keep_near_rods(const RodCull& query, Index* entries, int count, Index* found, float* squared_distance) {
  const Floats half = Floats{} + query.half_length;
  const Floats one = Floats{} + 1.0F;
  for (int lane = count; lane % float_lanes != 0; ++lane) entries[lane] = entries[0];
  int kept = 0;
  for (int i = 0; i < count; i += float_lanes) {
    const Index* at = entries + i;
    const Floats dx = gather(query.midpoint_x, at) - query.x;
    const Floats dy = gather(query.midpoint_y, at) - query.y;
    const Floats dz = gather(query.midpoint_z, at) - query.z;
    const Floats bx = gather(query.axis_x, at);
    const Floats by = gather(query.axis_y, at);
    const Floats bz = gather(query.axis_z, at);
    const Floats other_half = gather(query.half_lengths, at);
    const Floats reach = gather(query.margins, at) + query.keep;
    // Places s, t from the midpoints: the optimum of both lines clamped, then t for that s, then s for that
    // t. Where the rods are parallel any s will do.
    const Floats cosine = bx * query.ax + by * query.ay + bz * query.az;
    const Floats along = dx * query.ax + dy * query.ay + dz * query.az;
    const Floats other_along = dx * bx + dy * by + dz * bz;
    const Floats sine2 = one - cosine * cosine;
    const Floats divisor = sine2 > 1e-6F ? sine2 : one;
    Floats s = clamp((along - cosine * other_along) / divisor, -half, half);
    const Floats t = clamp(cosine * s - other_along, -other_half, other_half);
    s = clamp(cosine * t + along, -half, half);
    const Floats ex = dx + t * bx - s * query.ax;
    const Floats ey = dy + t * by - s * query.ay;
    const Floats ez = dz + t * bz - s * query.az;
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
