// Mori and Tanaka's stiffness of aligned fibers.
#pragma once

#include "base/law_text.hpp"
#include "continuum/homogenisation_laws/mean_field.hpp"

namespace fiberfate {

/// Fibers feel the mean strain of the matrix.
struct MoriTanaka {
  static constexpr LawText text = {"mori_tanaka", "Mean field with Eshelby's tensor.",
                                   "Benveniste, Mech. Mater. 6, 147 (1987)"};

  static Mat6 stiffness(const CompositeMaterial& material, double r) {
    return averaged_stiffness(material, lower_concentration(material, r));
  }
};

}  // namespace fiberfate
