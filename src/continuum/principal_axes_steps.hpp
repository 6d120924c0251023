// Steps that follow principal values and axes apart, for laws that retard the values only.
#pragma once

#include <cstdint>

#include "base/vector.hpp"
#include "continuum/orientation_law.hpp"

namespace fiberfate {

/// Advances A2 under RSC or RPR however near principal values are to each other.
///
/// Axes i and j turn at r_ij/(a_i - a_j), with r = Rᵀ F R the rate F of the law without retardation in the
/// axes R of A. Retarded values part slowly, and beside equal ones the axes follow those of F within (a_i -
/// a_j)/(r_ii - r_jj): explicit steps in the components of A2 must be shorter than that, which is nothing for
/// an isotropic start and a small kappa. Here a step h takes the axes from A + h F, which turns them by the
/// same amount as h -> 0 and into those of F as a_i - a_j -> 0, without any limit on h:
///   A + h F = R* diag(a*) R*ᵀ,   r = (a* - a)/h,   A <- R* diag(a + h rho(r)) R*ᵀ,
/// with rho what the retardation leaves of the rates r. This first-order step is extrapolated to sixth order
/// from 1, 2, ..., 6 parts (Aitken and Neville; Hairer, Norsett, Wanner, Solving Ordinary Differential
/// Equations I (1993), II.9); the last two orders tell the error. Equal values need no guide and no
/// threshold.
class PrincipalAxesSteps {
 public:
  /// `tolerance` bounds the error of a step (Frobenius norm of A2).
  PrincipalAxesSteps(const OrientationModel& model, const Mat3& gradient, double tolerance);

  /// Advances A2 by `duration` s; false when that takes more than `most_steps` steps, with A2 where it came
  /// to.
  bool advance(Mat3& second, double duration, std::int64_t most_steps);

  /// Rates that a step evaluates, 1 + 2 + ... + 6.
  static constexpr int evaluations = 21;

  [[nodiscard]] std::int64_t accepted() const { return accepted_; }
  [[nodiscard]] std::int64_t rejected() const { return rejected_; }
  /// Steps after which the state was returned to the admissible ones.
  [[nodiscard]] std::int64_t put_back() const { return put_back_; }

 private:
  static constexpr int order = 6;
  [[nodiscard]] Mat3 euler(const Mat3& second, double step) const;
  /// Takes one extrapolated step and tells its error.
  [[nodiscard]] Mat3 extrapolated(const Mat3& second, double step, double& error) const;

  OrientationLaw unretarded_;
  OrientationModel model_;
  Mat3 gradient_;
  double tolerance_;
  double next_step_ = 0;
  std::int64_t accepted_ = 0, rejected_ = 0, put_back_ = 0;
};

/// The law without its retardation: RSC and RPR (beta = 0) leave its steady states as they are.
[[nodiscard]] OrientationModel unretarded(const OrientationModel& model);

}  // namespace fiberfate
