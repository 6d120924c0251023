// Extrapolates first-order steps in principal axes.
#include "continuum/principal_axes_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "continuum/orientation_registry.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/eigenframe.hpp"

namespace fiberfate {

OrientationModel unretarded(const OrientationModel& model) {
  OrientationModel plain = model;
  plain.retardation = {};
  const OrientationConstants neutral;
  plain.constants.kappa = neutral.kappa;
  plain.constants.alpha = neutral.alpha;
  plain.constants.beta = neutral.beta;
  plain.constants.srf = neutral.srf;
  return plain;
}

PrincipalAxesSteps::PrincipalAxesSteps(const OrientationModel& model, const Mat3& gradient, double tolerance)
    : unretarded_(unretarded(model)), model_(model), gradient_(gradient), tolerance_(tolerance) {}

Mat3 PrincipalAxesSteps::euler(const Mat3& second, double step) const {
  const Vec3 values = eigenframe(second).values;
  const Eigenframe moved = eigenframe(second + step * unretarded_.unchecked_rate(second, gradient_));
  const Vec3 rates = (moved.values - values) / step;
  const Vec3 next = values + step * description_of(model_.retardation).left(model_.constants, rates);
  return moved.axes * next.asDiagonal() * moved.axes.transpose();
}

Mat3 PrincipalAxesSteps::extrapolated(const Mat3& second, double step, double& error) const {
  std::array<Mat3, order> row;  // row[k]: extrapolated k times from the present number of parts
  row.fill(second);
  for (int parts = 1; parts <= order; ++parts) {
    Mat3 state = second;
    for (int part = 0; part < parts; ++part) state = euler(state, step / parts);
    Mat3 before = row[0];
    row[0] = state;
    for (int k = 1; k < parts; ++k) {
      const Mat3 higher = row[k - 1] + (row[k - 1] - before) * (static_cast<double>(parts - k) / k);
      before = row[k];
      row[k] = higher;
    }
  }
  error = (row[order - 1] - row[order - 2]).norm();
  return row[order - 1];
}

bool PrincipalAxesSteps::advance(Mat3& second, double duration, std::int64_t most_steps) {
  const double fastest = unretarded_.unchecked_rate(second, gradient_).norm();
  if (!(next_step_ > 0))
    next_step_ = fastest > 0 ? 0.1 * std::pow(tolerance_, 1.0 / order) / fastest : duration;
  double done = 0;
  for (std::int64_t taken = 0; done < duration; ++taken) {
    if (taken >= most_steps || !(next_step_ > 1e-14 * duration)) return false;
    const bool last = done + next_step_ >= duration;
    const double step = last ? duration - done : next_step_;
    double error = 0;
    const Mat3 next = extrapolated(second, step, error);
    const double factor =
        error >= 0 ? std::clamp(0.9 * std::pow(tolerance_ / std::max(error, 1e-300), 1.0 / order), 0.2, 4.0)
                   : 0.2;
    if (!(error <= tolerance_)) {
      ++rejected_;
      next_step_ = step * factor;
      continue;
    }
    ++accepted_;
    second = next - (next.trace() - 1) / 3 * Mat3::Identity();
    if (eigenframe(second).values[2] < -tolerance_) ++put_back_;
    if (eigenframe(second).values[2] < 0) second = nearest_admissible(second);
    done = last ? duration : done + step;
    // A step cut short by the end says little about the next interval.
    next_step_ = last ? std::max(next_step_, step * factor) : step * factor;
  }
  return true;
}

}  // namespace fiberfate
