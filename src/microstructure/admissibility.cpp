// Checks and repairs orientation tensors.
#include "microstructure/admissibility.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
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

std::string format_tensor(const Mat3& a) {
  Mat3 rest = a;
  rest.diagonal().setZero();
  if (rest.isZero(1e-9)) return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", a(0, 0), a(1, 1), a(2, 2));
  return fmt::format("a11, a22, a33, a23, a31, a12 = [{:.4g}, {:.4g}, {:.4g}, {:.4g}, {:.4g}, {:.4g}]",
                     a(0, 0), a(1, 1), a(2, 2), a(1, 2), a(0, 2), a(0, 1));
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

void require_admissible(const Mat3& tensor, double tolerance) {
  if (!tensor.allFinite())
    throw InputError("the orientation tensor has a component that is not a number", "give six numbers");
  const Mat3 skew = tensor - tensor.transpose();
  if (skew.cwiseAbs().maxCoeff() > tolerance)
    throw InputError("the orientation tensor is not symmetric", "make a_ij equal to a_ji");
  if (std::abs(tensor.trace() - 1) > tolerance)
    throw InputError(
        fmt::format("the trace of the orientation tensor is {:.6g}, not 1", tensor.trace()),
        fmt::format("the nearest possible tensor is {}", format_tensor(nearest_admissible(tensor))));
  const double least = eigenframe(0.5 * (tensor + tensor.transpose())).values[2];
  if (least < -tolerance)
    throw InputError(
        fmt::format("the orientation tensor has the eigenvalue {:.4g}, and no fibers have a negative one",
                    least),
        fmt::format("the nearest possible tensor is {}", format_tensor(nearest_admissible(tensor))));
}

void require_forgivable(const Mat3& a) {
  // All invariants of A + forgiven I are positive exactly where no principal value is below -forgiven.
  const Mat3 b = a + forgiven_departure * Mat3::Identity();
  const Vec3 off(b(1, 2), b(2, 0), b(0, 1)), other(b(2, 1), b(0, 2), b(1, 0));
  const double minors = b(0, 0) * b(1, 1) + b(1, 1) * b(2, 2) + b(2, 2) * b(0, 0) - off.squaredNorm();
  const double determinant = b(0, 0) * (b(1, 1) * b(2, 2) - off[0] * off[0]) -
                             off[2] * (off[2] * b(2, 2) - off[0] * off[1]) +
                             off[1] * (off[2] * off[0] - b(1, 1) * off[1]);
  const bool sound = std::abs(a.trace() - 1) <= forgiven_departure && minors >= 0 && determinant >= 0 &&
                     (off - other).cwiseAbs().maxCoeff() <= forgiven_departure;
  if (!sound) require_admissible(a, forgiven_departure);
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
