// Gives the normal and friction force between two rods, or a rod and a wall.
#pragma once

#include <algorithm>
#include <cmath>

#include "dynamics/parameters.hpp"

namespace fiberfate {

/// Penalty force on overlapping rods: with the distance d of their axes and the mean radius a,
///   F_N = A 2a exp(−B (d/a − 2)) for d < d_cut = cutoff a
/// whose jump at d_cut is replaced by a ramp of width `ramp`, centred on d_cut, so that force and step
/// converge:
///   F_N = min(F_0 (1/2 − (d − d_cut)/ramp), A 2a exp(−B (d/a − 2))),   F_0 = A 2a exp(−B (cutoff − 2))
/// for d > d_cut − ramp, continuous as long as B ramp < 0.4 a.
/// Source: thesis (3.14), with d in units of the radius as its program computes it; the ramp is ours.
///
/// The kernel of contact_forces.hpp evaluates the same law in packs; this one is its specification.
class NormalForce {
 public:
  /// Holds the numbers that make up the law.
  struct Constants {
    double strength;  ///< A 2a, N
    double decay;     ///< B/a, 1/m
    double touch;     ///< 2a, m
    double cutoff;    ///< d_cut, m
    double ramp;      ///< m
    double step;      ///< F_0, N
  };

  NormalForce(const ContactParameters& contact, double mean_radius)
      : is_{contact.force_constant * 2 * mean_radius,
            contact.decay / mean_radius,
            2 * mean_radius,
            contact.cutoff * mean_radius,
            contact.ramp,
            0} {
    is_.step = exponential(is_.cutoff);
  }

  /// Returns F_N in N at the distance d in m.
  [[nodiscard]] double operator()(double distance) const {
    const double rise = is_.step * (0.5 - (distance - is_.cutoff) / is_.ramp);
    if (rise <= 0) return 0;
    // The ramp is below the exponential over its own width, except near its inner end, where they cross.
    if (distance > is_.cutoff - 0.4 * is_.ramp) return rise;
    return distance < is_.cutoff - is_.ramp ? exponential(distance) : std::min(rise, exponential(distance));
  }

  /// Returns an upper bound of −dF_N/dd in N/m at and around a distance where the force is `force`.
  [[nodiscard]] double stiffness(double force) const {
    return std::max(is_.step / is_.ramp, is_.decay * force);
  }

  /// Returns the distance from which on there is no force, m.
  [[nodiscard]] double reach() const { return is_.cutoff + 0.5 * is_.ramp; }

  [[nodiscard]] const Constants& constants() const { return is_; }

 private:
  [[nodiscard]] double exponential(double distance) const {
    return is_.strength * std::exp(-is_.decay * (distance - is_.touch));
  }

  Constants is_;
};

/// Coulomb friction, regularised so that it vanishes at rest: force = −resistance(F_N, |v_t|) v_t with
///   resistance = mu F_N / sqrt(v_t² + v_0²)
/// Source: thesis (3.15), with the tangential relative velocity.
struct Friction {
  double coefficient;    ///< mu
  double slip_velocity;  ///< v_0, m/s

  /// Returns the resistance in N s/m for a normal force in N and the square of the tangential velocity.
  [[nodiscard]] double operator()(double normal_force, double squared_velocity) const {
    return coefficient * normal_force / std::sqrt(squared_velocity + slip_velocity * slip_velocity);
  }
};

}  // namespace fiberfate
