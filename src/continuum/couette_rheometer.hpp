// Turns the speed of a Couette rheometer into a shear rate.
#pragma once

namespace fiberfate {

/// Chooses which shear rate stands for the whole gap.
enum class CouetteRate {
  narrow_gap,  ///< omega R_i/(R_o - R_i): the wall speed over the gap
  inner_wall,  ///< the exact rate at the inner cylinder, the highest
  outer_wall,  ///< the exact rate at the outer cylinder, the lowest
  mean,        ///< the exact rate, averaged over the volume of the gap
};

/// A rheometer of two coaxial cylinders, the inner one turning.
struct CouetteRheometer {
  double inner_radius = 0;     ///< R_i, m
  double outer_radius = 0;     ///< R_o, m
  double power_law_index = 1;  ///< n of the melt; 1 is Newtonian; not used by narrow_gap
  CouetteRate choice = CouetteRate::narrow_gap;
};

/// The shear rate at a speed in revolutions per minute, 1/s. For a power-law melt without wall slip
///   rate(r) = (2 omega/n) (R_i/r)^(2/n)/(1 - (R_i/R_o)^(2/n)),
/// from a shear stress that falls with 1/r^2 (Bird, Armstrong, Hassager, Dynamics of Polymeric Liquids 1,
/// 1987). Neglects end effects, secondary flow and viscous heating. Raises InputError unless 0 < R_i < R_o
/// and n > 0. The thesis' rates, 18.326 and 36.652 1/s at 50 and 100 rpm, are narrow_gap with R_i = 3.5 (R_o
/// - R_i).
[[nodiscard]] double shear_rate(const CouetteRheometer& rheometer, double revolutions_per_minute);

}  // namespace fiberfate
