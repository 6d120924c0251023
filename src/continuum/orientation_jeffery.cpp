// Evaluates Jeffery's motion with matrix exponentials and Carlson's integrals.
#include "continuum/orientation_jeffery.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <unsupported/Eigen/MatrixFunctions>

#include "base/constants.hpp"
#include "base/number_checks.hpp"
#include "microstructure/exact_closure.hpp"

namespace fiberfate {

Vec3 jeffery_rate(const Vec3& direction, const Mat3& gradient, double xi) {
  const Mat3 strain = 0.5 * (gradient + gradient.transpose());
  const Mat3 vorticity = 0.5 * (gradient - gradient.transpose());
  const Vec3 stretched = strain * direction;
  return vorticity * direction + xi * (stretched - direction.dot(stretched) * direction);
}

Mat3 fiber_deformation(const Mat3& gradient, double xi, double duration) {
  require_numbers("gradient", gradient.reshaped(), any_finite);
  require_number("xi", xi, {.lower = -1, .upper = 1});
  require_number("duration", duration, any_finite);
  const Mat3 strain = 0.5 * (gradient + gradient.transpose());
  const Mat3 vorticity = 0.5 * (gradient - gradient.transpose());
  return Mat3((vorticity + xi * strain) * duration).exp();
}

Vec3 carried_direction(const Vec3& direction, const Mat3& deformation) {
  return (deformation * direction).normalized();
}

Mat3 carried_isotropic_state(const Mat3& deformation) {
  require_numbers("deformation", deformation.reshaped(), any_finite);
  // F = U diag(s) Vᵀ gives C = U diag(1/s²) Uᵀ without squaring the condition of F.
  const Eigen::JacobiSVD<Eigen::MatrixXd> parts(deformation, Eigen::ComputeFullU);
  const Vec3 b = parts.singularValues().array().square().inverse();
  Vec3 values;
  for (int i = 0; i < 3; ++i) values[i] = carlson_rd(b[(i + 1) % 3], b[(i + 2) % 3], b[i]) / 3;
  const Mat3 axes = parts.matrixU();
  return axes * (values / values.sum()).asDiagonal() * axes.transpose();
}

double jeffery_period(double aspect_ratio, double rate) {
  require_number("aspect_ratio", aspect_ratio, positive);
  require_number("rate", rate, positive);
  return 2 * pi * (aspect_ratio + 1 / aspect_ratio) / rate;
}

}  // namespace fiberfate
