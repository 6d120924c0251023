// Simple shear, elongations, and the largest principal rate.
#include "microstructure/flow.hpp"

#include <Eigen/Eigenvalues>

namespace fiberfate {

Flow simple_shear(double rate, double viscosity) {
  Flow flow;
  flow.gradient(0, 1) = rate;
  flow.viscosity = viscosity;
  return flow;
}

Mat3 simple_shear_gradient() {
  return simple_shear(1).gradient;
}

Mat3 planar_elongation_gradient() {
  return Vec3(0.5, 0, -0.5).asDiagonal();
}

Mat3 uniaxial_elongation_gradient() {
  return (Vec3(2, -1, -1) / (2 * std::sqrt(3.0))).asDiagonal();
}

Mat3 biaxial_elongation_gradient() {
  return -uniaxial_elongation_gradient();
}

double principal_rate(const Flow& flow) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(flow.rate_of_strain(), Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
}

}  // namespace fiberfate
