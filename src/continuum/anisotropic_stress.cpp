// Contracts A4 with the rate of strain.
#include "continuum/anisotropic_stress.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

void require_flow(const Mat3& strain, const Mat6& fourth) {
  require_numbers("strain", strain.reshaped(), any_finite);
  require_numbers("fourth", fourth.reshaped(), any_finite);
}

}  // namespace

Mat3 anisotropic_stress(double viscosity, double fiber_term, const Mat3& strain, const Mat6& fourth) {
  require_number("viscosity", viscosity, not_negative);
  require_number("fiber_term", fiber_term, not_negative);
  require_flow(strain, fourth);
  return 2 * viscosity * (strain + fiber_term * contracted(fourth, strain));
}

double stretching_share(const Mat3& strain, const Mat6& fourth) {
  require_flow(strain, fourth);
  const double largest = strain.cwiseAbs().maxCoeff();
  if (!(largest > 0)) {
    double traced = 0;
    for (int m = 0; m < 6; ++m) traced += multiplicity_of[m] * fourth(m, m);
    return (traced - fourth.topLeftCorner<3, 3>().sum() / 3) / 5;
  }
  const Mat3 shape = strain / largest;  // D:D of a very slow flow would vanish
  return double_dot(shape, contracted(fourth, shape)) / double_dot(shape, shape);
}

double informed_isotropic_viscosity(double viscosity, double trouton_term, const Mat3& strain,
                                    const Mat6& fourth) {
  require_number("viscosity", viscosity, not_negative);
  require_number("trouton_term", trouton_term, not_negative);
  return viscosity * (1 + trouton_term * stretching_share(strain, fourth));
}

double particle_number(double aspect_ratio, double volume_fraction) {
  if (!(aspect_ratio > 1) || !std::isfinite(aspect_ratio) || !(volume_fraction > 0) || !(volume_fraction < 1))
    throw InputError(
        fmt::format("no particle number belongs to an aspect ratio of {:g} and a volume fraction of {:g}",
                    aspect_ratio, volume_fraction),
        "the aspect ratio is above 1 and the volume fraction between 0 and 1");
  return aspect_ratio * aspect_ratio / (3 * 0.5 * std::log(pi / volume_fraction));
}

}  // namespace fiberfate
