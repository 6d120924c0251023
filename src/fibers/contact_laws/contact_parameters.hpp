// What a user may choose about contact between fibers, and between fibers and walls.
#pragma once

#include <string>

namespace fiberfate {

/// The laws of contact and their constants.
struct ContactParameters {
  std::string law = "exponential";  ///< of the normal force: a row of contact_laws()
  double force_constant = 500;  ///< A of "exponential", N/m: F_N = A D exp(−B (d/a − 2)); 0: no contact
  double decay = 2;             ///< B of "exponential"
  double cutoff = 2;            ///< d_cut of "exponential" in radii: the force acts for d < d_cut a
  double ramp = 1e-6;           ///< of "exponential": width over which the force rises at d_cut, m
  double poisson_ratio = 0.22;  ///< nu of "hertz"; the default is that of E glass
  std::string friction_law = "coulomb";  ///< a row of friction_laws() (dynamics)
  double friction = 0.2;                 ///< mu, rod on rod
  double wall_friction = 0.2;            ///< mu, rod on wall
  double slip_velocity = 1e-5;           ///< speed below which friction fades to zero, m/s
  int sweeps = 1;                        ///< solves a step; each renews the predicted gap and slip
};

/// Describes one of two fibers that touch.
struct ContactBody {
  double radius = 0;          ///< a, m
  double youngs_modulus = 0;  ///< E, Pa
};

/// Describes two fibers that touch.
struct ContactPair {
  ContactBody first, second;
  [[nodiscard]] double mean_radius() const { return 0.5 * (first.radius + second.radius); }
};

/// Where two rods are to each other.
template <class Number>
struct ContactGap {
  Number distance;  ///< of the axes, m
  Number sine;      ///< of the angle between them, in [0, 1]
};

/// What packing takes of a law (its soft contact, packing/rod_repulsion.hpp): the force rises in
/// proportion to the overlap up to `force`, within `ramp` centred on the distance `cutoff`, and then grows
/// with 1 + x + x²/2, x = decay (2 − d/a). No force: fibers do not feel each other at rest.
struct RestingContact {
  double cutoff = 0;  ///< radii
  double ramp = 0;    ///< m
  double force = 0;   ///< N
  double decay = 0;
};

}  // namespace fiberfate
