// The hydrodynamic resistance of one rod: what every law of drag gives.
#pragma once

namespace fiberfate {

/// Resistance of a rod, which cannot stretch, to the strain of the melt about its centre, N m s; it enters
/// the power that drag dissipates (dissipation.hpp), not the rod's motion.
struct StrainResistance {
  double along = 0;   ///< s_0, to stretching along the rod
  double aslant = 0;  ///< s_1, to shear that would turn it
  double across = 0;  ///< s_2, to strain across it
};

/// The resistance of a rod with direction p in a flow u(x) = kappa·x of rate of strain D and spin
/// Omega:
///   F = [parallel p p + perpendicular (I − p p)] · (u(c) − v_c)
///   T = rotational (Omega + shape p × (D·p) − omega), across p
/// A free rod then obeys Jeffery's equation with the shape factor `shape`. Spin about p is free of torque.
struct RodDrag {
  double parallel = 0;       ///< N s/m
  double perpendicular = 0;  ///< N s/m
  double rotational = 0;     ///< N m s
  double shape = 0;          ///< (r_e² − 1)/(r_e² + 1), dimensionless
  StrainResistance strain;
};

/// The drag in a melt of so many times the viscosity.
[[nodiscard]] inline RodDrag scaled(const RodDrag& drag, double factor) {
  const StrainResistance& strain = drag.strain;
  return {factor * drag.parallel,
          factor * drag.perpendicular,
          factor * drag.rotational,
          drag.shape,
          {factor * strain.along, factor * strain.aslant, factor * strain.across}};
}

/// Describes the rod whose resistance is wanted, and the fiber that it is part of: a law may depend on both.
struct RodShape {
  double length = 0;  ///< l, m
  double radius = 0;  ///< a, m
  double fiber_length =
      0;  ///< L, m: of the fiber as it is now, all its rods together; 0: the rod is the fiber

  /// Returns L/2a.
  [[nodiscard]] double fiber_aspect_ratio() const {
    return (fiber_length > 0 ? fiber_length : length) / (2 * radius);
  }
};

}  // namespace fiberfate
