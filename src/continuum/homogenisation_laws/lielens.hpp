// Lielens' stiffness of aligned fibers.
#pragma once

#include "base/law_text.hpp"
#include "continuum/homogenisation_laws/mean_field.hpp"

namespace fiberfate {

/// Between the lower bound and the upper one, which has the phases exchanged: the inverses of the strain
/// concentrations are interpolated with the weight phi (1 + phi)/2.
struct Lielens {
  static constexpr LawText text = {
      "lielens", "Between the two Hashin-Shtrikman-Willis bounds; stiffer at high fractions.",
      "Lielens et al., Composites A 29, 63 (1998)"};

  static Mat6 stiffness(const CompositeMaterial& material, double r) {
    const Mat6 fiber = isotropic_stiffness(material.fiber), matrix = isotropic_stiffness(material.matrix);
    const Mat6 upper = dilute_concentration(eshelby_tensor(r, material.fiber.poisson), matrix, fiber);
    const double weight = 0.5 * material.volume_fraction * (1 + material.volume_fraction);
    return averaged_stiffness(
        material, inverse((1 - weight) * inverse(lower_concentration(material, r)) + weight * upper));
  }
};

}  // namespace fiberfate
