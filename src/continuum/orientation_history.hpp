// Follows the orientation through a homogeneous flow history.
#pragma once

#include <functional>
#include <vector>

#include "base/vector.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/runge_kutta.hpp"
#include "microstructure/flow_history.hpp"

namespace fiberfate {

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
  /// Raises InputError unless the history is one of steps, the start admissible to 1e-6 and the tolerance
  /// positive.
  OrientationIntegrator(OrientationLaw law, FlowHistory history, const OrientationState& start,
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
  FlowHistory history_;
  OrientationState state_;
  IntegrationTolerance tolerance_;
  IntegrationRecord record_;
  std::int64_t projections_ = 0;
};

}  // namespace fiberfate
