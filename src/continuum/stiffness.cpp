// Computes with elastic stiffness tensors in plain components.
#include "continuum/stiffness.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "microstructure/admissibility.hpp"

namespace fiberfate {
namespace {

double delta(int i, int j) {
  return i == j ? 1 : 0;
}

}  // namespace

Mat6 isotropic_stiffness(const IsotropicElasticity& material) {
  if (!(material.modulus > 0) || !std::isfinite(material.modulus) || !(material.poisson > -1) ||
      !(material.poisson < 0.5))
    throw InputError(
        fmt::format("no elastic material has E = {:g} Pa and nu = {:g}", material.modulus, material.poisson),
        "E is positive and nu between -1 and 1/2");
  const double shear = material.modulus / (2 * (1 + material.poisson));
  const double lame = 2 * shear * material.poisson / (1 - 2 * material.poisson);
  Mat6 stiffness = 2 * shear * symmetric_identity();
  stiffness.topLeftCorner<3, 3>().array() += lame;
  return stiffness;
}

Mat6 orthotropic_stiffness(const EngineeringConstants& c) {
  for (const double modulus : {c.e1, c.e2, c.e3, c.g23, c.g31, c.g12})
    require_number("modulus", modulus, positive);
  for (const double ratio : {c.nu23, c.nu31, c.nu12}) require_number("poisson", ratio, any_finite);
  Mat3 compliance;
  compliance << 1 / c.e1, -c.nu12 / c.e1, -c.nu31 / c.e3,  //
      -c.nu12 / c.e1, 1 / c.e2, -c.nu23 / c.e2,            //
      -c.nu31 / c.e3, -c.nu23 / c.e2, 1 / c.e3;
  Mat6 stiffness = Mat6::Zero();
  stiffness.topLeftCorner<3, 3>() = compliance.inverse();
  stiffness.diagonal().tail<3>() << c.g23, c.g31, c.g12;
  return stiffness;
}

bool stores_energy(const Mat6& stiffness) {
  // Weighted by sqrt(2) off the diagonal, the energy is an ordinary quadratic form of the strain components.
  const Vec6 weight = Eigen::Map<const Vec6>(multiplicity_of).cwiseSqrt();
  const Mat6 symmetric = 0.5 * (stiffness + stiffness.transpose());
  return Mat6(weight.asDiagonal() * symmetric * weight.asDiagonal()).llt().info() == Eigen::Success;
}

double youngs_modulus_along(const Mat6& compliance, const Vec3& direction) {
  const Mat3 dyad = direction * direction.transpose();
  return 1 / double_dot(dyad, contracted(compliance, dyad));
}

EngineeringConstants engineering_constants(const Mat6& stiffness) {
  require_numbers("stiffness", stiffness.reshaped(), any_finite);
  // C_ijkl as a plain 6×6 matrix takes engineering shear strains (2 e_ij) to stresses, so its inverse gives
  // compliances.
  const Mat6 s = stiffness.inverse();
  EngineeringConstants c;
  c.e1 = 1 / s(0, 0);
  c.e2 = 1 / s(1, 1);
  c.e3 = 1 / s(2, 2);
  c.g23 = 1 / s(3, 3);
  c.g31 = 1 / s(4, 4);
  c.g12 = 1 / s(5, 5);
  c.nu23 = -s(1, 2) * c.e2;
  c.nu31 = -s(2, 0) * c.e3;
  c.nu12 = -s(0, 1) * c.e1;
  return c;
}

Mat6 orientation_average(const Mat6& t, const Mat6& fourth, const Mat3& a) {
  require_numbers("fourth", fourth.reshaped(), any_finite);
  require_forgivable(a);
  const double b1 = t(0, 0) + t(1, 1) - t(0, 1) - t(1, 0) - 4 * t(5, 5);
  const double b2_upper = t(0, 1) - t(1, 2), b2_lower = t(1, 0) - t(1, 2);
  const double b3 = t(5, 5) + 0.5 * (t(1, 2) - t(1, 1));
  const double b4 = t(1, 2), b5 = 0.5 * (t(1, 1) - t(1, 2));
  Mat6 average;
  for (int m = 0; m < 6; ++m) {
    for (int n = 0; n < 6; ++n) {
      const int i = row_of[m], j = column_of[m], k = row_of[n], l = column_of[n];
      average(m, n) =
          b1 * fourth(m, n) + b2_upper * a(i, j) * delta(k, l) + b2_lower * delta(i, j) * a(k, l) +
          b3 * (a(i, k) * delta(j, l) + a(i, l) * delta(j, k) + a(j, l) * delta(i, k) +
                a(j, k) * delta(i, l)) +
          b4 * delta(i, j) * delta(k, l) + b5 * (delta(i, k) * delta(j, l) + delta(i, l) * delta(j, k));
    }
  }
  return average;
}

Mat3 orientation_average(const Mat3& t, const Mat3& second) {
  require_forgivable(second);
  return (t(0, 0) - t(1, 1)) * second + t(1, 1) * Mat3::Identity();
}

}  // namespace fiberfate
