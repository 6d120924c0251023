// Culls sixteen rods at a time in single precision.
#include "base/simd.hpp"
#include "fibers/rod_cull.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {
constexpr int width = 16;
typedef float Floats __attribute__((vector_size(64)));
typedef std::int32_t Bits __attribute__((vector_size(64)));
typedef float UnalignedFloats __attribute__((vector_size(64), aligned(4)));

static inline __attribute__((always_inline)) Floats read(const float* from) {
  return *reinterpret_cast<const UnalignedFloats*>(from);
}
}  // namespace

int cull_rods(const RodCull& query, Index begin, Index end, Index* found) {
  int count = 0;
  for (Index first = begin; first < end; first += width) {
    const Floats dx = read(query.midpoint_x + first) - query.x;
    const Floats dy = read(query.midpoint_y + first) - query.y;
    const Floats dz = read(query.midpoint_z + first) - query.z;
    const Floats along = dx * query.ax + dy * query.ay + dz * query.az;
    const Floats low = along < -query.half_length ? Floats{} - query.half_length : along;
    const Floats place = low > query.half_length ? Floats{} + query.half_length : low;
    const Floats ex = dx - place * query.ax;
    const Floats ey = dy - place * query.ay;
    const Floats ez = dz - place * query.az;
    const Floats reach = read(query.half_lengths + first) + read(query.margins + first) + query.keep;
    const Bits near = ex * ex + ey * ey + ez * ez <= reach * reach;
    const int lanes_left = end - first < width ? static_cast<int>(end - first) : width;
    for (int lane = 0; lane < lanes_left; ++lane) {
      found[count] = first + lane;
      count -= near[lane];
    }
  }
  return count;
}

}  // namespace fiberfate::FIBERFATE_ISA
