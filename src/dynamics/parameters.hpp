// Lists everything that a user may choose about the motion of fibers.
#pragma once

#include <cstdint>

namespace fiberfate {

/// Names the laws of hydrodynamic drag on a rod (physics: docs/theory/particles.md).
enum class DragLaw {
  beads,  ///< chain of touching beads, real-valued bead number m = l/2a (Schmid, Switzer & Klingenberg 2000)
  beads_integer,  ///< the same with floor(l/2a) beads, as the published program has it; for comparison only
  ellipsoid,      ///< resistance functions of a prolate spheroid (Kim & Karrila 1991)
};

/// Holds the constants of contact between rods, and between rods and walls.
struct ContactParameters {
  double force_constant = 500;  ///< A, N/m: F_N = A D exp(−B (d/a − 2)); 0 switches contact off
  double decay = 2;             ///< B
  double cutoff = 2;            ///< d_cut in radii: the force acts for d < d_cut a
  double ramp = 1e-6;           ///< width over which the force rises at d_cut, centred on it, m
  double friction = 0.2;        ///< mu, rod on rod
  double wall_friction = 0.2;   ///< mu, rod on wall
  double slip_velocity = 1e-5;  ///< speed below which friction fades to zero, m/s
  int sweeps = 1;               ///< solves a step; each renews the predicted gap and slip
};

/// Names the breakage criteria.
enum class BreakageLaw { none, fixed, probability, strength };

/// Holds the constants of breakage (thesis section 3.3.3).
struct BreakageParameters {
  BreakageLaw law = BreakageLaw::none;
  double critical_radius = 204.6e-6;  ///< R_crit of `fixed`, m; the default is the loop test's mean
  double minimum_radius = 119e-6;     ///< R_min of `probability` and `strength`, m
  double maximum_radius = 371e-6;     ///< R_max of `probability` and `strength`, m
  double exponent = 15;               ///< m of equation (3.33)
  double check_interval = 1e-3;       ///< physical time between two checks, s
};

/// Says who chooses the time step.
enum class StepControl { fixed, adaptive };

/// Holds how time is stepped.
struct StepParameters {
  StepControl control = StepControl::adaptive;
  double initial = 1e-5;     ///< first step of `adaptive`, every step of `fixed`, s
  double minimum = 1e-10;    ///< below this the simulation fails, s
  double maximum = 1e-3;     ///< s
  double tolerance = 0.005;  ///< displacement error a step that `adaptive` allows, rms over nodes, in radii
  double maximum_strain = 0.05;  ///< most strain of the flow in one step of `adaptive`
};

/// Holds all choices about the motion of fibers.
struct DynamicsParameters {
  DragLaw drag = DragLaw::beads;
  ContactParameters contact;
  BreakageParameters breakage;
  StepParameters step;
  std::uint64_t seed = 1;
};

}  // namespace fiberfate
