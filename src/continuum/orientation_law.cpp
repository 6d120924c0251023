// Hands single points and batches to the orientation kernels.
#include "continuum/orientation_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/kernels.hpp"
#include "base/number_checks.hpp"
#include "base/threads.hpp"
#include "continuum/orientation_kernels.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/principal_axes_steps.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/eigenframe.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {
namespace {

/// Points that one thread takes at a time: a multiple of eight whose arrays fit the nearest cache.
constexpr std::size_t chunk = 256;

void evaluate_on_this_thread(const OrientationModel& model, const OrientationPoints& points) {
  return FIBERFATE_KERNEL(evaluate_orientation)(model, points);
}

std::size_t advance_on_this_thread(const OrientationModel& model, const OrientationPoints& points,
                                   const OrientationStep& step, std::size_t& put_back) {
  return FIBERFATE_KERNEL(advance_orientation)(model, points, step, put_back);
}

std::size_t find_fault(const OrientationPoints& points) {
  return FIBERFATE_KERNEL(find_orientation_fault)(points, forgiven_departure);
}

OrientationPoints part_of(const OrientationPoints& points, std::size_t first, std::size_t most) {
  OrientationPoints part = points;
  part.count = std::min(most, points.count - first);
  for (const double*& array : part.second) array += first * points.second_stride;
  for (const double*& array : part.gradient) array += first * points.gradient_stride;
  for (double*& array : part.result) array += first * points.result_stride;
  return part;
}

/// Calls body(part, index of its first point) for all parts, on all threads.
template <class Body>
void for_each_part(const OrientationPoints& points, const Body& body) {
  const std::size_t parts = (points.count + chunk - 1) / chunk;
  if (parts == 1) return body(points, 0);
  parallel_for(static_cast<std::ptrdiff_t>(parts), [&](std::size_t i) {
    const std::size_t first = i * chunk;
    body(part_of(points, first, chunk), first);
  });
}

/// Keeps the lowest index of a point that threads complain of.
class FirstPoint {
 public:
  void complain(std::size_t point) {
    std::size_t before = first_;
    while (point < before && !first_.compare_exchange_weak(before, point)) {
    }
  }
  [[nodiscard]] bool any() const { return first_ != nobody; }
  [[nodiscard]] std::size_t point() const { return first_; }

 private:
  static constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();
  std::atomic<std::size_t> first_ = nobody;
};

Mat3 second_at(const OrientationPoints& points, std::size_t i) {
  Vec6 a;
  for (int m = 0; m < 6; ++m) a[m] = points.second[m][i * points.second_stride];
  return to_matrix(a);
}

Mat3 gradient_at(const OrientationPoints& points, std::size_t i) {
  Mat3 l;
  for (int m = 0; m < 9; ++m) l(m / 3, m % 3) = points.gradient[m][i * points.gradient_stride];
  return l;
}

[[noreturn]] void refuse_point(const OrientationPoints& points, std::size_t i) {
  const std::string fault = fault_of(second_at(points, i), forgiven_departure);
  if (!fault.empty())
    throw InputError(fmt::format("the orientation tensor of point {} is impossible: {}", i, fault),
                     "give a symmetric tensor of unit trace without negative principal values");
  throw InputError(fmt::format("the velocity gradient of point {} is not finite, or beyond 1e100 1/s", i),
                   "give nine finite numbers");
}

void require_sound(const OrientationPoints& points) {
  FirstPoint faulty;
  for_each_part(points, [&](const OrientationPoints& part, std::size_t first) {
    const std::size_t fault = find_fault(part);
    if (fault < part.count) faulty.complain(first + fault);
  });
  if (faulty.any()) refuse_point(points, faulty.point());
}

/// Explicit steps after which a law that acts on principal values is followed by principal_axes_steps.hpp.
constexpr int most_explicit_steps = 2000;

bool advance_along_axes(const OrientationModel& model, const OrientationPoints& point,
                        const OrientationStep& step, OrientationAdvance& advance) {
  PrincipalAxesSteps steps(model, gradient_at(point, 0), step.tolerance);
  Mat3 second = second_at(point, 0);
  // As many evaluations as explicit steps of four would take.
  const std::int64_t most_steps = 1 + 4 * std::int64_t{step.most_steps} / PrincipalAxesSteps::evaluations;
  if (!steps.advance(second, step.duration, most_steps)) return false;
  advance.put_back += steps.put_back() > 0 ? 1 : 0;
  const Vec6 a = to_components(second);
  for (int m = 0; m < 6; ++m) point.result[m][0] = a[m];
  return true;
}

/// Advances one point by itself; returns false when it needs too many steps.
bool advance_alone(const OrientationModel& model, const OrientationPoints& point, const OrientationStep& step,
                   OrientationAdvance& advance) {
  if (acts_on_principal_values(model.retardation) && advance_along_axes(model, point, step, advance))
    return true;
  return advance_on_this_thread(model, point, step, advance.put_back) == 1;
}

/// Advances consecutive points; returns how many it did, which is all of them unless one needs too many
/// steps.
std::size_t advance_part(const OrientationModel& model, const OrientationPoints& points,
                         const OrientationStep& step, OrientationAdvance& advance) {
  OrientationStep limited = step;
  if (acts_on_principal_values(model.retardation))
    limited.most_steps = std::min(step.most_steps, most_explicit_steps);
  std::size_t done = 0;
  while (done < points.count) {
    done += advance_on_this_thread(model, part_of(points, done, points.count), limited, advance.put_back);
    // One point of eight takes too many steps for the others: each goes by itself.
    const std::size_t stop = std::min(done + 8, points.count);
    for (; done < stop; ++done)
      if (!advance_alone(model, part_of(points, done, 1), step, advance)) return done;
  }
  return done;
}

/// A point by itself, whose kernel writes to `result`.
class SinglePoint {
 public:
  SinglePoint(const Mat3& second, const Mat3& gradient) : second_(to_components(second)) {
    for (int m = 0; m < 9; ++m) gradient_[m] = gradient(m / 3, m % 3);
    points_.count = 1;
    for (int m = 0; m < 6; ++m) {
      points_.second[m] = &second_[m];
      points_.result[m] = &result_[m];
    }
    for (int m = 0; m < 9; ++m) points_.gradient[m] = &gradient_[m];
  }
  SinglePoint(const SinglePoint&) = delete;
  SinglePoint& operator=(const SinglePoint&) = delete;

  [[nodiscard]] const OrientationPoints& points() const { return points_; }
  [[nodiscard]] Mat3 result() const { return to_matrix(result_); }

 private:
  Vec6 second_, result_;
  Eigen::Matrix<double, 9, 1> gradient_;
  OrientationPoints points_;
};

}  // namespace

OrientationLaw::OrientationLaw(const OrientationModel& model) : model_(model) {
  require_admissible(model);
}

Mat3 OrientationLaw::rate(const Mat3& second, const Mat3& gradient) const {
  require_forgivable(second);
  require_numbers("gradient", gradient.reshaped(), {.lower = -1e100, .upper = 1e100});
  return unchecked_rate(second, gradient);
}

Mat3 OrientationLaw::unchecked_rate(const Mat3& second, const Mat3& gradient) const {
  const SinglePoint point(second, gradient);
  evaluate_on_this_thread(model_, point.points());
  return point.result();
}

void OrientationLaw::evaluate(const OrientationPoints& points) const {
  if (points.count == 0) return;
  FirstPoint faulty;
  for_each_part(points, [&](const OrientationPoints& part, std::size_t first) {
    const std::size_t fault = find_fault(part);
    if (fault < part.count) return faulty.complain(first + fault);
    evaluate_on_this_thread(model_, part);
  });
  if (faulty.any()) refuse_point(points, faulty.point());
}

OrientationAdvance OrientationLaw::advance(const OrientationPoints& points,
                                           const OrientationStep& step) const {
  require_number("duration", step.duration, not_negative);
  require_number("tolerance", step.tolerance, positive);
  OrientationAdvance advance;
  if (points.count == 0) return advance;
  require_sound(points);
  FirstPoint late;
  std::atomic<std::size_t> put_back = 0;
  for_each_part(points, [&](const OrientationPoints& part, std::size_t first) {
    OrientationAdvance one;
    const std::size_t done = advance_part(model_, part, step, one);
    if (done < part.count) late.complain(first + done);
    put_back += one.put_back;
  });
  if (late.any())
    throw SimulationFailure(
        fmt::format(
            "the orientation of point {} did not get through {:g} s in {} steps: its velocity gradient "
            "is too large for this time step, or the closure is unstable there (linear, orp)",
            late.point(), step.duration, step.most_steps),
        {});
  advance.put_back = put_back;
  return advance;
}

Mat3 rotary_diffusion(const OrientationModel& model, const Mat3& second, const Mat3& gradient) {
  require_forgivable(second);
  require_numbers("gradient", gradient.reshaped(), any_finite);
  const SinglePoint point(second, gradient);
  FIBERFATE_KERNEL(evaluate_rotary_diffusion)(model, point.points());
  return point.result();
}

std::vector<std::string> doubts(const OrientationModel& model, const Mat3& second, const Mat3& gradient) {
  std::vector<std::string> found;
  const Mat3 diffusion = rotary_diffusion(model, second, gradient);
  const double least = eigenframe(diffusion).values[2];
  if (least < -1e-12 * diffusion.cwiseAbs().maxCoeff())
    found.push_back(
        fmt::format("the rotary diffusion tensor of {} is indefinite here (smallest principal value {:.3g}): "
                    "diffusion concentrates fibers instead of spreading them ({})",
                    name(model.diffusion), least, description_of(model.diffusion).meaning));
  if (model.constants.u0 > 8 * diffusion.trace() / 3 && model.constants.u0 > 0)
    found.push_back(
        fmt::format("the potential u0 = {:g} exceeds 8 C_I = {:g}: the isotropic state at rest is unstable",
                    model.constants.u0, 8 * diffusion.trace() / 3));
  return found;
}

double shape_factor(double aspect_ratio) {
  if (!(aspect_ratio > 0))
    throw InputError(fmt::format("an aspect ratio of {:g} is impossible", aspect_ratio),
                     "give length over diameter, a positive number");
  const double inverse_square = 1 / (aspect_ratio * aspect_ratio);
  return aspect_ratio > 1 ? (1 - inverse_square) / (1 + inverse_square)
                          : (aspect_ratio * aspect_ratio - 1) / (aspect_ratio * aspect_ratio + 1);
}

}  // namespace fiberfate
