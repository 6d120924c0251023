// Evaluates the integrals of the exact closure and inverts them with Newton's method.
#include "microstructure/exact_closure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/vector.hpp"

namespace fiberfate {
namespace {

/// Below this a principal value is replaced by the planar or aligned limit.
constexpr double smallest_value = 1e-9;
/// Step of the trapezoidal rule in ln s. The integrands are analytic for |Im ln s| < pi, so the error falls
/// as exp(-2 pi² / step): 7e-18 here.
constexpr double step = 0.5;
/// The integrands fall at least as s for s -> 0 and as s^(-3/2) for s -> infinity; both tails end below
/// 1e-16.
constexpr double lower_tail = 37, upper_tail = 25;
constexpr int most_iterations = 60;

struct Moments {
  Vec3 second = Vec3::Zero();       // a_i
  Mat3 sensitivity = Mat3::Zero();  // -d a_i / d b_j
  Mat3 fourth = Mat3::Zero();       // A_iijj
};

Moments moments_of(const Vec3& shape) {
  Moments sum;
  const double first = std::log(shape.minCoeff()) - lower_tail;
  const double last = std::log(shape.maxCoeff()) + upper_tail;
  const int count = static_cast<int>((last - first) / step) + 1;
  for (int k = 0; k < count; ++k) {
    const double s = std::exp(first + k * step);
    const Vec3 inverse = (shape.array() + s).inverse();
    const double weight = step * s * std::sqrt(inverse.prod());
    sum.second += 0.5 * weight * inverse;
    const Mat3 product = 0.25 * weight * inverse * inverse.transpose();
    sum.sensitivity += product;
    sum.fourth += s * product;
  }
  sum.sensitivity.diagonal() *= 3;
  sum.fourth.diagonal() *= 3;
  return sum;
}

}  // namespace

bool find_exact_shape(const double values[3], double shape[3]) {
  const Vec3 target(values[0], values[1], values[2]);
  Vec3 logarithm = -1.2 * target.array().log();
  logarithm.array() -= logarithm.mean();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Vec3 b = logarithm.array().exp();
    const Moments now = moments_of(b);
    const Vec3 error = (now.second.array() / target.array()).log();
    const Mat3 fall = now.second.cwiseInverse().asDiagonal() * now.sensitivity * b.asDiagonal();
    const Vec3 change = fall.fullPivLu().solve(error);
    if (!change.allFinite()) return false;
    const double longest = change.cwiseAbs().maxCoeff();
    logarithm += std::min(1.0, 2 / longest) * change;
    if (longest < 1e-13 * std::max(1.0, logarithm.cwiseAbs().maxCoeff()) || longest < 3e-14) {
      Eigen::Map<Vec3> found(shape);
      found = logarithm.array().exp();
      return true;
    }
  }
  return false;
}

void close_exactly(const double values[3], double components[6]) {
  Vec3 safe(values[0], values[1], values[2]);
  safe = safe.cwiseMax(smallest_value);
  safe /= safe.sum();
  Vec3 shape;
  find_exact_shape(safe.data(), shape.data());
  const Moments found = moments_of(shape);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    components[3 + i] = found.fourth(j, k);
    components[i] = values[i] - found.fourth(i, j) - found.fourth(i, k);
  }
}

double carlson_rd(double x, double y, double z) {
  const double first_mean = (x + y + 3 * z) / 5;
  const double first_x = first_mean - x, first_y = first_mean - y;
  const double spread = std::max({std::abs(first_x), std::abs(first_y), std::abs(first_mean - z)});
  double mean = first_mean, scale = 1, sum = 0;
  while (scale * spread > 2e-3 * mean) {  // the series then errs by less than 1e-17
    const double root_x = std::sqrt(x), root_y = std::sqrt(y), root_z = std::sqrt(z);
    const double shift = root_x * root_y + root_y * root_z + root_z * root_x;
    sum += scale / (root_z * (z + shift));
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    mean = (mean + shift) / 4;
    scale /= 4;
  }
  const double dx = first_x * scale / mean, dy = first_y * scale / mean, dz = -(dx + dy) / 3;
  const double e2 = dx * dy - 6 * dz * dz, e3 = (3 * dx * dy - 8 * dz * dz) * dz;
  const double e4 = 3 * (dx * dy - dz * dz) * dz * dz, e5 = dx * dy * dz * dz * dz;
  const double series = 1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 +
                        3 * e5 / 26 - e2 * e2 * e2 / 16 + 3 * e3 * e3 / 40 + 3 * e2 * e4 / 20;
  return scale * series / (mean * std::sqrt(mean)) + 3 * sum;
}

}  // namespace fiberfate
