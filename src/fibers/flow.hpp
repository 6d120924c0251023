// Describes the homogeneous flow that carries the fibers: velocity gradient and matrix viscosity over time.
#pragma once

#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// The flow at one instant: u(x) = gradient · x.
struct Flow {
  Mat3 gradient = Mat3::Zero();  ///< kappa_ij = d u_i / d x_j, 1/s
  double viscosity = 0;          ///< of the matrix, Pa s

  /// Rate of strain D = (kappa + kappaᵀ)/2, 1/s.
  [[nodiscard]] Mat3 rate_of_strain() const { return 0.5 * (gradient + gradient.transpose()); }
  /// Angular velocity of the fluid Omega = curl u / 2, rad/s; W·p = Omega × p.
  [[nodiscard]] Vec3 angular_velocity() const {
    return 0.5 * Vec3(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0),
                      gradient(1, 0) - gradient(0, 1));
  }
};

/// Makes simple shear u_x = rate · y.
[[nodiscard]] Flow simple_shear(double rate, double viscosity);

/// Largest principal rate of strain, 1/s: the distance of two fluid points changes at most at this relative
/// rate.
[[nodiscard]] double principal_rate(const Flow& flow);

/// One row of a flow history: this simple shear acts until `end_time`.
struct FlowInterval {
  double end_time = 0;   ///< s
  double rate = 0;       ///< shear rate, 1/s
  double viscosity = 0;  ///< Pa s
};

/// A flow that is constant in each of consecutive intervals; the last one lasts for ever.
/// Steps of the integrator never straddle an interval's end, so a history is followed exactly.
class FlowHistory {
 public:
  /// Takes intervals of strictly increasing end times (the last may be infinite); raises InputError
  /// otherwise.
  explicit FlowHistory(std::vector<FlowInterval> intervals);
  /// Makes a constant simple shear.
  static FlowHistory constant(double rate, double viscosity);
  /// Makes the ramp of thesis figure 3.24: `steps` equal steps from rate/steps to rate within `duration`,
  /// then rate.
  static FlowHistory ramp(double rate, double viscosity, double duration, int steps);

  /// The flow on [time, next_change(time)).
  [[nodiscard]] Flow at(double time) const;
  /// The first time after `time` at which the flow changes; infinity when it never does.
  [[nodiscard]] double next_change(double time) const;
  [[nodiscard]] const std::vector<FlowInterval>& intervals() const { return intervals_; }

 private:
  [[nodiscard]] std::size_t interval_at(double time) const;
  std::vector<FlowInterval> intervals_;
};

}  // namespace fiberfate
