// Converts, contracts and rotates orientation tensors.
#include "microstructure/tensor.hpp"

#include <Eigen/LU>

namespace fiberfate {
namespace {

/// Expresses rotation of symmetric tensors as a matrix on their plain components.
Mat6 rotation_of_components(const Mat3& rotation) {
  Mat6 turn;
  for (int m = 0; m < 6; ++m) {
    for (int n = 0; n < 6; ++n) {
      const double once = rotation(row_of[m], row_of[n]) * rotation(column_of[m], column_of[n]);
      const double swapped = rotation(row_of[m], column_of[n]) * rotation(column_of[m], row_of[n]);
      turn(m, n) = n < 3 ? once : once + swapped;
    }
  }
  return turn;
}

const Eigen::Map<const Vec6> multiplicities(multiplicity_of);

}  // namespace

Vec6 to_components(const Mat3& tensor) {
  Vec6 components;
  for (int m = 0; m < 6; ++m)
    components[m] = 0.5 * (tensor(row_of[m], column_of[m]) + tensor(column_of[m], row_of[m]));
  return components;
}

Mat3 to_matrix(const Vec6& components) {
  Mat3 tensor;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) tensor(i, j) = components[place_of[i][j]];
  return tensor;
}

Mat3 contracted(const Mat6& tensor, const Mat3& symmetric) {
  return to_matrix(tensor * multiplicities.cwiseProduct(to_components(symmetric)));
}

Mat6 composed(const Mat6& left, const Mat6& right) {
  return left * multiplicities.asDiagonal() * right;
}

double double_dot(const Mat3& left, const Mat3& right) {
  return left.cwiseProduct(right).sum();
}

Mat3 rotated(const Mat3& tensor, const Mat3& rotation) {
  return rotation * tensor * rotation.transpose();
}

Mat6 rotated(const Mat6& tensor, const Mat3& rotation) {
  const Mat6 turn = rotation_of_components(rotation);
  return turn * tensor * turn.transpose();
}

Mat6 fourth_power(const Vec3& direction) {
  const Vec6 second = to_components(direction * direction.transpose());
  return second * second.transpose();
}

Mat6 symmetric_identity() {
  return multiplicities.cwiseInverse().asDiagonal();
}

Mat6 inverse(const Mat6& tensor) {
  const Vec6 weights = multiplicities.cwiseInverse();
  return weights.asDiagonal() * tensor.inverse() * weights.asDiagonal();
}

}  // namespace fiberfate
