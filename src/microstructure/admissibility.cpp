// Checks and repairs orientation tensors.
#include "microstructure/admissibility.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "microstructure/eigenframe.hpp"

namespace fiberfate {
namespace {

/// Projects on the simplex sum a_i = 1, a_i >= 0; values in falling order. Held, Wolfe, Crowder, Math.
/// Program. 6, 62 (1974): a common shift, and what falls below zero is cut.
Vec3 onto_simplex(const Vec3& values) {
  double sum = 0, shift = 0;
  for (int i = 0; i < 3; ++i) {
    sum += values[i];
    const double candidate = (sum - 1) / (i + 1);
    if (values[i] - candidate > 0) shift = candidate;
  }
  return (values.array() - shift).cwiseMax(0.0);
}

double asymmetry_of(const Mat6& fourth) {
  double worst = (fourth - fourth.transpose()).cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) {
          const double here = fourth(place_of[i][j], place_of[k][l]);
          worst = std::max(worst, std::abs(here - fourth(place_of[i][k], place_of[j][l])));
        }
      }
    }
  }
  return worst;
}

}  // namespace

std::string fault_of(const Mat3& second, double tolerance) {
  if (!second.allFinite()) return "a component is not a finite number";
  const double asymmetry = (second - second.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry > tolerance) return fmt::format("it is not symmetric (by {:.3g})", asymmetry);
  if (std::abs(second.trace() - 1) > tolerance)
    return fmt::format("its trace is {:.12g}, not 1", second.trace());
  const double least = eigenframe(second).values[2];
  if (least < -tolerance) return fmt::format("its smallest principal value is {:.3g}, below 0", least);
  return {};
}

std::string fault_of(const Mat6& fourth, const Mat3& second, double tolerance) {
  if (!fourth.allFinite()) return "a component is not a finite number";
  const double asymmetry = asymmetry_of(fourth);
  if (asymmetry > tolerance) return fmt::format("it is not symmetric in all indices (by {:.3g})", asymmetry);
  const double mismatch = (contracted(fourth, Mat3::Identity()) - second).cwiseAbs().maxCoeff();
  if (mismatch > tolerance) return fmt::format("A_ijkk differs from A_ij by {:.3g}", mismatch);
  // Components weighted by sqrt(2) off the diagonal make X:A4:X an ordinary quadratic form.
  const Vec6 weight = Eigen::Map<const Vec6>(multiplicity_of).cwiseSqrt();
  const Mat6 form = weight.asDiagonal() * fourth * weight.asDiagonal();
  const double least = Eigen::SelfAdjointEigenSolver<Mat6>(form).eigenvalues()[0];
  if (least < -tolerance) return fmt::format("X:A4:X reaches {:.3g}, below 0", least);
  return {};
}

Mat3 nearest_admissible(const Mat3& tensor) {
  const Mat3 symmetric = 0.5 * (tensor + tensor.transpose());
  const Eigenframe frame = eigenframe(symmetric);
  return frame.axes * onto_simplex(frame.values).asDiagonal() * frame.axes.transpose();
}

}  // namespace fiberfate
