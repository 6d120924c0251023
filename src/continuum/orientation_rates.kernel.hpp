// Evaluates orientation laws at many points and integrates them over a time step.
#include "continuum/orientation_kernels.hpp"
#include "continuum/orientation_pack.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

/// Velocity gradients (1/s) whose squares are still numbers.
constexpr double fastest_gradient = 1e100;

/// Reads eight values; the last blocks repeat their last point.
FIBERFATE_INLINE Pack gather(const double* from, std::size_t stride, std::size_t first, int filled) {
  Pack pack;
  if (stride == 1 && filled == lanes) {
    __builtin_memcpy(&pack, from + first, sizeof(pack));
    return pack;
  }
  for (int i = 0; i < lanes; ++i)
    pack[i] = from[(first + static_cast<std::size_t>(i < filled ? i : filled - 1)) * stride];
  return pack;
}

FIBERFATE_INLINE void scatter(double* to, std::size_t stride, std::size_t first, int filled,
                              const Pack& pack) {
  if (stride == 1 && filled == lanes) {
    __builtin_memcpy(to + first, &pack, sizeof(pack));
    return;
  }
  for (int i = 0; i < filled; ++i) to[(first + static_cast<std::size_t>(i)) * stride] = pack[i];
}

struct Eight {
  Symmetric second;
  Pack gradient[9];
  Mask put_back;  ///< where the state left the admissible ones
};

FIBERFATE_INLINE Eight read(const OrientationPoints& points, std::size_t first, int filled) {
  Pack a[6];
  for (int m = 0; m < 6; ++m) a[m] = gather(points.second[m], points.second_stride, first, filled);
  Eight eight;
  eight.put_back = Mask{};
  eight.second = {a[0], a[1], a[2], a[3], a[4], a[5]};
  for (int m = 0; m < 9; ++m)
    eight.gradient[m] = gather(points.gradient[m], points.gradient_stride, first, filled);
  return eight;
}

FIBERFATE_INLINE void write(const OrientationPoints& points, std::size_t first, int filled,
                            const Symmetric& a) {
  const Pack component[6] = {a.c11, a.c22, a.c33, a.c23, a.c31, a.c12};
  for (int m = 0; m < 6; ++m) scatter(points.result[m], points.result_stride, first, filled, component[m]);
}

/// Largest Frobenius norm of eight tensors; NaN when one of them is.
FIBERFATE_INLINE double largest_norm(const Symmetric& a) {
  const Pack norm = square_root(double_dot(a, a));
  double largest = 0;
  for (int i = 0; i < lanes; ++i)
    if (!(norm[i] <= largest)) largest = norm[i];
  return largest;
}

/// By how much the next step may be longer: 0.9 (tolerance/error)^(1/3) within [0.2, 4]; a NaN shortens it.
FIBERFATE_INLINE double step_factor(double error, double tolerance) {
  if (!(error >= 0)) return 0.2;
  const double factor = error > 0 ? 0.9 * __builtin_cbrt(tolerance / error) : 4;
  if (factor > 4) return 4;
  return factor > 0.2 ? factor : 0.2;
}

/// Where a state and its flow are what a law takes. All invariants of A + forgiven I are positive
/// exactly where no principal value is below -forgiven; comparisons with NaN are false.
FIBERFATE_INLINE Mask sound(const Eight& eight, double forgiven) {
  const Symmetric& a = eight.second;
  const Symmetric b = a + isotropic(broadcast(forgiven));
  const Pack minors =
      b.c11 * b.c22 + b.c22 * b.c33 + b.c33 * b.c11 - b.c12 * b.c12 - b.c23 * b.c23 - b.c31 * b.c31;
  Mask good = (magnitude(trace(a) - 1.0) <= forgiven) & (minors >= 0.0) & (determinant(b) >= 0.0);
  for (int m = 0; m < 9; ++m) good &= magnitude(eight.gradient[m]) < fastest_gradient;
  return good;
}

/// Returns to unit trace and, where an approximate closure has left a principal value below -`tolerated`, to
/// the admissible states: values below zero set to zero and the others reduced in proportion.
FIBERFATE_INLINE Symmetric admissible(const Symmetric& a, double tolerated, Mask& put_back) {
  const Symmetric b = a - isotropic((trace(a) - 1.0) / 3.0);
  const Pack minors =
      b.c11 * b.c22 + b.c22 * b.c33 + b.c33 * b.c11 - b.c12 * b.c12 - b.c23 * b.c23 - b.c31 * b.c31;
  // Round-off of the determinant hides a small value beside another: such states are looked at closely.
  if (!any((determinant(b) < 1e-16) | (minors < 1e-16))) return b;
  Frame frame = find_frame(b);
  const Mask outside = frame.value[2] < -tolerated;
  if (!any(outside)) return b;
  put_back |= outside;
  for (int k = 0; k < 3; ++k) frame.value[k] = larger(frame.value[k], broadcast(0));
  const Pack sum = frame.value[0] + frame.value[1] + frame.value[2];
  const Pack zero = broadcast(0);
  const Symmetric c = out_of_frame(
      frame, {frame.value[0] / sum, frame.value[1] / sum, frame.value[2] / sum, zero, zero, zero});
  return {choose(outside, c.c11, b.c11), choose(outside, c.c22, b.c22), choose(outside, c.c33, b.c33),
          choose(outside, c.c23, b.c23), choose(outside, c.c31, b.c31), choose(outside, c.c12, b.c12)};
}

/// Integrates eight points with Bogacki and Shampine's pair 3(2), Appl. Math. Lett. 2, 321 (1989); the step
/// is that of the point that needs the smallest. Returns the number of internal steps.
int integrate(const OrientationModel& model, Eight& eight, const OrientationStep& step) {
  Symmetric& a = eight.second;
  double done = 0, size = step.duration;
  Symmetric k1 = orientation_rate(model, a, eight.gradient);
  const double fastest = largest_norm(k1);
  if (fastest * size > 0.1) size = 0.1 / fastest;
  int count = 0;
  for (; count < step.most_steps && done < step.duration; ++count) {
    const bool last = done + size >= step.duration;
    if (last) size = step.duration - done;
    const Symmetric k2 = orientation_rate(model, a + (0.5 * size) * k1, eight.gradient);
    const Symmetric k3 = orientation_rate(model, a + (0.75 * size) * k2, eight.gradient);
    const Symmetric next = a + size * ((2.0 / 9) * k1 + (1.0 / 3) * k2 + (4.0 / 9) * k3);
    const Symmetric k4 = orientation_rate(model, next, eight.gradient);
    const double error =
        size * largest_norm((-5.0 / 72) * k1 + (1.0 / 12) * k2 + (1.0 / 9) * k3 - (1.0 / 8) * k4);
    if (error <= step.tolerance) {
      a = admissible(next, step.tolerance, eight.put_back);
      // A state that was put back has another slope; that of round-off in the trace is the same.
      k1 = largest_norm(a - next) > step.tolerance ? orientation_rate(model, a, eight.gradient) : k4;
      done = last ? step.duration : done + size;
    }
    size *= step_factor(error, step.tolerance);
  }
  return count;
}

}  // namespace

void evaluate_orientation(const OrientationModel& model, const OrientationPoints& points) {
  for (std::size_t first = 0; first < points.count; first += lanes) {
    const int filled = points.count - first < lanes ? static_cast<int>(points.count - first) : lanes;
    const Eight eight = read(points, first, filled);
    write(points, first, filled, orientation_rate(model, eight.second, eight.gradient));
  }
}

void evaluate_rotary_diffusion(const OrientationModel& model, const OrientationPoints& points) {
  for (std::size_t first = 0; first < points.count; first += lanes) {
    const int filled = points.count - first < lanes ? static_cast<int>(points.count - first) : lanes;
    const Eight eight = read(points, first, filled);
    write(points, first, filled, rotary_diffusion_of(model, eight.second, eight.gradient));
  }
}

std::size_t find_orientation_fault(const OrientationPoints& points, double forgiven) {
  for (std::size_t first = 0; first < points.count; first += lanes) {
    const int filled = points.count - first < lanes ? static_cast<int>(points.count - first) : lanes;
    const Mask good = sound(read(points, first, filled), forgiven);
    for (int i = 0; i < filled; ++i)
      if (!good[i]) return first + static_cast<std::size_t>(i);
  }
  return points.count;
}

std::size_t advance_orientation(const OrientationModel& model, const OrientationPoints& points,
                                const OrientationStep& step, std::size_t& put_back) {
  for (std::size_t first = 0; first < points.count; first += lanes) {
    const int filled = points.count - first < lanes ? static_cast<int>(points.count - first) : lanes;
    Eight eight = read(points, first, filled);
    const Pack departure = magnitude(trace(eight.second) - 1.0);
    eight.put_back |= departure > step.tolerance;
    if (integrate(model, eight, step) >= step.most_steps) return first;
    Mask slightly{};  // round-off of planar states is no departure
    write(points, first, filled, admissible(eight.second, 0, slightly));
    for (int i = 0; i < filled; ++i) put_back += eight.put_back[i] ? 1 : 0;
  }
  return points.count;
}

}  // namespace fiberfate::FIBERFATE_ISA
