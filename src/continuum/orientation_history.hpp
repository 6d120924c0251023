// Follows the orientation through a homogeneous flow history.
#pragma once

#include <functional>
#include <vector>

#include "base/vector.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/runge_kutta.hpp"

namespace fiberfate {

/// A velocity gradient that acts until `end_time`.
struct GradientInterval {
  double end_time = 0;           ///< s
  Mat3 gradient = Mat3::Zero();  ///< L_ij = d v_i / d x_j, 1/s
};

/// A velocity gradient that is constant in each of consecutive intervals; the last lasts for ever.
class GradientHistory {
 public:
  /// Takes intervals of strictly rising end times; raises InputError for none, for times that do not rise
  /// from 0, or for numbers that are not finite (the last end may be infinite).
  explicit GradientHistory(std::vector<GradientInterval> intervals);
  /// Makes a constant flow.
  static GradientHistory constant(const Mat3& gradient);
  /// Makes a history that runs linearly from row to row of a table (times rising from 0; constant after the
  /// last), each stretch cut in `pieces` intervals that take the gradient of their middle: the deviation of
  /// A2 falls with pieces squared.
  static GradientHistory interpolated(const std::vector<double>& times, const std::vector<Mat3>& gradients,
                                      int pieces);

  /// The gradient on [time, next_change(time)).
  [[nodiscard]] const Mat3& at(double time) const;
  /// The first time after `time` at which the gradient changes; infinity when it never does.
  [[nodiscard]] double next_change(double time) const;

 private:
  [[nodiscard]] std::size_t interval_at(double time) const;
  std::vector<GradientInterval> intervals_;
};

/// Frequent gradients of unit rate sqrt(2 D:D) = 1 1/s; multiply by the rate.
[[nodiscard]] Mat3 simple_shear_gradient();         ///< v_1 = x_3
[[nodiscard]] Mat3 planar_elongation_gradient();    ///< diag(1, 0, -1)/2
[[nodiscard]] Mat3 uniaxial_elongation_gradient();  ///< diag(2, -1, -1)/(2 sqrt 3)
[[nodiscard]] Mat3 biaxial_elongation_gradient();   ///< the opposite

/// One state of the history.
struct OrientationState {
  double time = 0;  ///< s
  Mat3 second = Mat3::Identity() / 3;
};

/// Integrates an orientation law through a flow history with Dormand and Prince's method, and with
/// PrincipalAxesSteps where RSC or RPR make that stiff; steps end at every
/// change of the flow and at the wanted times. Unit trace is kept to round-off; a state that an approximate
/// closure has left with a negative principal value is returned to the nearest admissible one and counted.
class OrientationIntegrator {
 public:
  /// Raises InputError unless the start is admissible to 1e-6 and the tolerance positive.
  OrientationIntegrator(OrientationLaw law, GradientHistory history, const OrientationState& start,
                        IntegrationTolerance tolerance = {});

  /// Advances to a time not before the present one (InputError otherwise). Raises SimulationFailure when the
  /// step size falls to nothing or the steps run out.
  void advance_to(double time);

  [[nodiscard]] const OrientationState& state() const { return state_; }
  [[nodiscard]] const IntegrationRecord& record() const { return record_; }
  [[nodiscard]] std::int64_t projections() const { return projections_; }

 private:
  /// Each of these leaves the state as it is when it returns false.
  [[nodiscard]] bool advance_over(const Mat3& gradient, double duration);
  [[nodiscard]] bool advance_explicitly(const Mat3& gradient, double duration, std::int64_t most_steps);
  /// Goes on where explicit steps would become tiny beside equal principal values.
  [[nodiscard]] bool advance_axes(const Mat3& gradient, double duration);

  OrientationLaw law_;
  GradientHistory history_;
  OrientationState state_;
  IntegrationTolerance tolerance_;
  IntegrationRecord record_;
  std::int64_t projections_ = 0;
};

}  // namespace fiberfate
