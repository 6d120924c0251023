// Stores and turns the orientation tensors A2 and A4: components, contractions and rotations.
#pragma once

#include <Eigen/Core>

#include "base/vector.hpp"

namespace fiberfate {

/// Six components in the order 11, 22, 33, 23, 31, 12 (plain tensor components, no factors of 2).
using Vec6 = Eigen::Matrix<double, 6, 1>;
/// T_ijkl of a tensor with minor symmetries as [ij][kl], both pairs in the order of Vec6, plain
/// components.
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// Row and column of the six components.
inline constexpr int row_of[6] = {0, 1, 2, 1, 2, 0};
inline constexpr int column_of[6] = {0, 1, 2, 2, 0, 1};
/// The place of component (i, j) among the six.
inline constexpr int place_of[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};
/// How often each of the six components occurs in the full tensor: the weights of a contraction.
inline constexpr double multiplicity_of[6] = {1, 1, 1, 2, 2, 2};

/// Collects the six components of a symmetric tensor; the antisymmetric part of the argument is dropped.
[[nodiscard]] Vec6 to_components(const Mat3& tensor);
/// Spreads six components to the full symmetric tensor.
[[nodiscard]] Mat3 to_matrix(const Vec6& components);

/// Contracts (T : X)_ij = T_ijkl X_kl.
[[nodiscard]] Mat3 contracted(const Mat6& tensor, const Mat3& symmetric);
/// Contracts (S : T)_ijkl = S_ijmn T_mnkl.
[[nodiscard]] Mat6 composed(const Mat6& left, const Mat6& right);
/// Contracts X : Y = X_ij Y_ij.
[[nodiscard]] double double_dot(const Mat3& left, const Mat3& right);

/// Turns a tensor with a rotation R: T'_ij = R_im R_jn T_mn.
[[nodiscard]] Mat3 rotated(const Mat3& tensor, const Mat3& rotation);
/// Turns a tensor with a rotation R: T'_ijkl = R_im R_jn R_ko R_lp T_mnop.
[[nodiscard]] Mat6 rotated(const Mat6& tensor, const Mat3& rotation);

/// Makes p p p p of one direction.
[[nodiscard]] Mat6 fourth_power(const Vec3& direction);
/// Makes the identity on symmetric tensors, I_ijkl = (d_ik d_jl + d_il d_jk) / 2.
[[nodiscard]] Mat6 symmetric_identity();
/// Inverts a tensor with minor symmetries: T : T⁻¹ is the symmetric identity. Singular tensors give
/// infinities.
[[nodiscard]] Mat6 inverse(const Mat6& tensor);

}  // namespace fiberfate
