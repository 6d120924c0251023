// Hands single points and batches to the orientation kernels.
#include "continuum/orientation_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "base/error.hpp"
#include "base/kernels.hpp"
#include "base/threads.hpp"
#include "continuum/orientation_kernels.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/eigenframe.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {
namespace {

/// Points that one thread takes at a time: a multiple of eight whose arrays fit the nearest cache.
constexpr std::size_t chunk = 256;

void evaluate_on_this_thread(const OrientationModel& model, const OrientationPoints& points) {
  return FIBERFATE_KERNEL(evaluate_orientation)(model, points);
}

bool advance_on_this_thread(const OrientationModel& model, const OrientationPoints& points,
                            const OrientationStep& step) {
  return FIBERFATE_KERNEL(advance_orientation)(model, points, step);
}

OrientationPoints part_of(const OrientationPoints& points, std::size_t first) {
  OrientationPoints part = points;
  part.count = std::min(chunk, points.count - first);
  for (const double*& array : part.second) array += first * points.second_stride;
  for (const double*& array : part.gradient) array += first * points.gradient_stride;
  for (double*& array : part.result) array += first * points.result_stride;
  return part;
}

template <class Body>
void for_each_part(const OrientationPoints& points, const Body& body) {
  const std::size_t parts = (points.count + chunk - 1) / chunk;
  if (parts == 1) return body(part_of(points, 0));
  parallel_for(static_cast<std::ptrdiff_t>(parts),
               [&](std::ptrdiff_t i) { body(part_of(points, static_cast<std::size_t>(i) * chunk)); });
}

Mat3 along_axes(const Mat3& second, const Mat3& strain, Vec3 constants) {
  const Eigenframe frame = eigenframe(second, strain);
  const Mat3 inside = frame.axes.transpose() * strain * frame.axes;
  const double rate = std::sqrt(2 * double_dot(strain, strain));
  const auto aimless = [&](int i) {
    return frame.values[i] - frame.values[i + 1] < equal_principal_values &&
           inside(i, i) - inside(i + 1, i + 1) < equal_principal_values * rate;
  };
  if (aimless(0) && aimless(1)) {
    constants.setConstant(constants.mean());
  } else if (aimless(0)) {
    constants.head<2>().setConstant(constants.head<2>().mean());
  } else if (aimless(1)) {
    constants.tail<2>().setConstant(constants.tail<2>().mean());
  }
  return frame.axes * constants.asDiagonal() * frame.axes.transpose();
}

}  // namespace

OrientationLaw::OrientationLaw(const OrientationModel& model) : model_(model) {
  require_admissible(model);
}

Mat3 OrientationLaw::rate(const Mat3& second, const Mat3& gradient) const {
  const Vec6 a = to_components(second);
  Eigen::Matrix<double, 9, 1> l;
  for (int k = 0; k < 9; ++k) l[k] = gradient(k / 3, k % 3);
  Vec6 result;
  OrientationPoints point;
  point.count = 1;
  for (int m = 0; m < 6; ++m) {
    point.second[m] = &a[m];
    point.result[m] = &result[m];
  }
  for (int m = 0; m < 9; ++m) point.gradient[m] = &l[m];
  evaluate_on_this_thread(model_, point);
  return to_matrix(result);
}

void OrientationLaw::evaluate(const OrientationPoints& points) const {
  if (points.count == 0) return;
  for_each_part(points, [this](const OrientationPoints& part) { evaluate_on_this_thread(model_, part); });
}

void OrientationLaw::advance(const OrientationPoints& points, const OrientationStep& step) const {
  if (points.count == 0) return;
  std::atomic<bool> arrived = true;
  for_each_part(points, [&](const OrientationPoints& part) {
    if (!advance_on_this_thread(model_, part, step)) arrived = false;
  });
  if (!arrived)
    throw SimulationFailure(
        fmt::format(
            "the orientation did not get through {:g} s in {} steps: the velocity "
            "gradients are too large for this time step, or the closure is unstable there (linear, orp)",
            step.duration, step.most_steps),
        {});
}

Mat3 rotary_diffusion(const OrientationModel& model, const Mat3& second, const Mat3& gradient) {
  const OrientationConstants& c = model.constants;
  const Mat3 identity = Mat3::Identity();
  const Mat3 strain = 0.5 * (gradient + gradient.transpose());
  const double rate = std::sqrt(2 * double_dot(strain, strain));
  const Mat3 n = rate > 0 ? Mat3(strain / rate) : Mat3::Zero();
  switch (model.diffusion) {
    case RotaryDiffusion::folgar_tucker:
      return c.c_i * identity;
    case RotaryDiffusion::ard:
      return c.b1 * identity + c.b2 * second + c.b3 * second * second + c.b4 * n + c.b5 * n * n;
    case RotaryDiffusion::iard: {
      const Mat3 n2 = n * n;
      const double size = std::sqrt(0.5 * double_dot(n2, n2));
      return c.c_i * (size > 0 ? Mat3(identity - c.c_m / size * n2) : identity);
    }
    case RotaryDiffusion::pard:
      return c.c_i * along_axes(second, strain, {1, c.omega, 1 - c.omega});
    case RotaryDiffusion::mrd:
      return c.c_i * along_axes(second, strain, {c.d1, c.d2, c.d3});
    case RotaryDiffusion::wpt:
      return c.b1 * identity + c.b3 * second * second;
    case RotaryDiffusion::none:
      break;
  }
  return Mat3::Zero();
}

std::vector<std::string> doubts(const OrientationModel& model, const Mat3& second, const Mat3& gradient) {
  std::vector<std::string> found;
  const Mat3 diffusion = rotary_diffusion(model, second, gradient);
  const double least = eigenframe(diffusion).values[2];
  if (least < -1e-12 * diffusion.cwiseAbs().maxCoeff())
    found.push_back(fmt::format(
        "the rotary diffusion tensor of {} is indefinite here (smallest principal value {:.3g}): "
        "diffusion concentrates fibers instead of spreading them{}",
        name(model.diffusion), least,
        model.diffusion == RotaryDiffusion::iard ? "; in uniaxial flow this happens for C_M > 3/4" : ""));
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
