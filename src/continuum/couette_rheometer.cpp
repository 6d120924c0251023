// Evaluates the shear rates of Couette flow.
#include "continuum/couette_rheometer.hpp"

#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

double exact_rate(const CouetteRheometer& rheometer, double speed, double radius) {
  const double exponent = 2 / rheometer.power_law_index;
  const double ratio = rheometer.inner_radius / rheometer.outer_radius;
  return exponent * speed * std::pow(rheometer.inner_radius / radius, exponent) /
         (1 - std::pow(ratio, exponent));
}

/// 2/(R_o^2 - R_i^2) times the integral of rate(r) r dr.
double mean_rate(const CouetteRheometer& rheometer, double speed) {
  const double inner = rheometer.inner_radius, outer = rheometer.outer_radius;
  const double power = 2 - 2 / rheometer.power_law_index;
  const double at_inner_wall = exact_rate(rheometer, speed, inner);
  const double logarithm = std::log(outer / inner);
  // (x^p - 1)/p with x = R_o/R_i, which is ln x for a Newtonian melt.
  const double integral = power == 0 ? logarithm : std::expm1(power * logarithm) / power;
  return 2 * inner * inner * at_inner_wall * integral / (outer * outer - inner * inner);
}

}  // namespace

double shear_rate(const CouetteRheometer& rheometer, double revolutions_per_minute) {
  require_number("revolutions_per_minute", revolutions_per_minute, not_negative);
  require_number("outer_radius", rheometer.outer_radius, any_finite);
  require_number("power_law_index", rheometer.power_law_index, any_finite);
  if (!(rheometer.inner_radius > 0) || !(rheometer.outer_radius > rheometer.inner_radius))
    throw InputError("the radii of the Couette rheometer do not enclose a gap",
                     "give inner_radius above zero and outer_radius above it");
  if (!(rheometer.power_law_index > 0))
    throw InputError("the power-law index of the Couette rheometer is not positive", "1 is Newtonian");
  const double speed = 2 * pi * revolutions_per_minute / 60;
  switch (rheometer.choice) {
    case CouetteRate::inner_wall:
      return exact_rate(rheometer, speed, rheometer.inner_radius);
    case CouetteRate::outer_wall:
      return exact_rate(rheometer, speed, rheometer.outer_radius);
    case CouetteRate::mean:
      return mean_rate(rheometer, speed);
    case CouetteRate::narrow_gap:
      break;
  }
  return speed * rheometer.inner_radius / (rheometer.outer_radius - rheometer.inner_radius);
}

}  // namespace fiberfate
