// Finds the closest points of many pairs of rods at once; closest_points() is its specification.
#include "base/simd.hpp"
#include "fibers/segment_block.hpp"

namespace fiberfate::FIBERFATE_ISA {

/// Fills s, t, separation and distance of the first `count` pairs of a block (rounded up to whole packs).
void find_segment_distances(SegmentBlock& block, int count) {
  const Pack zero = broadcast(0);
  for (int i = 0; i < count; i += lanes) {
    const Pack rx = load(block.offset[0] + i), ry = load(block.offset[1] + i), rz = load(block.offset[2] + i);
    const Pack ux = load(block.first[0] + i), uy = load(block.first[1] + i), uz = load(block.first[2] + i);
    const Pack vx = load(block.second[0] + i), vy = load(block.second[1] + i), vz = load(block.second[2] + i);
    const Pack uu = ux * ux + uy * uy + uz * uz;
    const Pack vv = vx * vx + vy * vy + vz * vz;
    const Pack uv = ux * vx + uy * vy + uz * vz;
    const Pack ur = ux * rx + uy * ry + uz * rz;
    const Pack vr = vx * rx + vy * ry + vz * rz;
    const Pack sine2 = uu * vv - uv * uv;
    const Mask parallel = sine2 <= parallel_sine2 * uu * vv;

    // Lines that cross at an angle: the optimum of both lines, clamped to the first segment.
    const Pack skew = clamp((uv * vr - ur * vv) / choose(parallel, broadcast(1), sine2), 0, 1);
    // Parallel lines: the middle of the stretch of the first segment that lies alongside the second.
    const Pack at_begin = clamp(-ur / uu, 0, 1);
    const Pack at_end = clamp((uv - ur) / uu, 0, 1);
    Pack s = choose(parallel, 0.5 * (at_begin + at_end), skew);
    const Pack t = clamp((uv * s + vr) / vv, 0, 1);
    s = choose(parallel, s, clamp((uv * t - ur) / uu, 0, 1));

    const Pack dx = rx + s * ux - t * vx;
    const Pack dy = ry + s * uy - t * vy;
    const Pack dz = rz + s * uz - t * vz;
    store(block.s + i, s);
    store(block.t + i, t);
    store(block.separation[0] + i, dx);
    store(block.separation[1] + i, dy);
    store(block.separation[2] + i, dz);
    store(block.distance + i, square_root(larger(dx * dx + dy * dy + dz * dz, zero)));
  }
}

}  // namespace fiberfate::FIBERFATE_ISA
