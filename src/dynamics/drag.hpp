// Gives the hydrodynamic resistance of one rod, by the law that the case chooses.
#pragma once

#include "dynamics/parameters.hpp"

namespace fiberfate {

/// Holds the resistance of a rod with direction p in a flow u(x) = kappa·x of rate of strain D and spin
/// Omega:
///   F = [parallel p p + perpendicular (I − p p)] · (u(c) − v_c)
///   T = rotational (Omega + shape p × (D·p) − omega), across p
/// A free rod then obeys Jeffery's equation with the shape factor `shape`. Spin about p is free of torque.
struct RodDrag {
  double parallel = 0;       ///< N s/m
  double perpendicular = 0;  ///< N s/m
  double rotational = 0;     ///< N m s
  double shape = 0;          ///< (r_e² − 1)/(r_e² + 1), dimensionless
};

/// Describes the rod whose resistance is wanted.
struct RodShape {
  double length = 0;  ///< l, m
  double radius = 0;  ///< a, m
};

/// Chain of touching beads of radius a, with the real-valued number m = l/(2a) of them:
///   parallel = perpendicular = 6 pi eta a m,   rotational = 6 pi eta a S2 + 8 pi eta a³ m,   S2 = a² m (m² −
///   1)/3
/// so that the rods of a straight fiber add up to the fiber itself and r_e = sqrt((m² + 1)/2). Valid for l >=
/// 2a. Neglects hydrodynamic interaction of the beads. Source: thesis (3.4) to (3.9), corrected; Schmid et
/// al. (2000).
struct BeadDrag {
  double viscosity;  ///< eta, Pa s
  [[nodiscard]] RodDrag operator()(const RodShape& rod) const;
};

/// The same with floor(l/(2a)) beads, at least one, as the published program counts them; for comparison
/// only: it makes the answer depend on how a fiber is cut into rods.
struct IntegerBeadDrag {
  double viscosity;  ///< eta, Pa s
  [[nodiscard]] RodDrag operator()(const RodShape& rod) const;
};

/// Prolate spheroid with semi-axes l/2 and a, resistance functions X^A, Y^A, Y^C, Y^H; exact for a lone
/// spheroid in Stokes flow: shape = Y^H/Y^C = (r² − 1)/(r² + 1), r = l/(2a) > 1. Source: Kim & Karrila
/// (1991), table 3.4.
struct EllipsoidDrag {
  double viscosity;  ///< eta, Pa s
  [[nodiscard]] RodDrag operator()(const RodShape& rod) const;
};

/// Evaluates the chosen law.
[[nodiscard]] RodDrag rod_drag(DragLaw law, double viscosity, const RodShape& rod);

}  // namespace fiberfate
