// What the mean-field models of aligned fibers share.
#pragma once

#include "continuum/homogenisation.hpp"

namespace fiberfate {

/// Strain in the inclusion over strain far away: (I + S : M⁻¹ : (F - M))⁻¹.
[[nodiscard]] Mat6 dilute_concentration(const Mat6& eshelby, const Mat6& inclusion, const Mat6& matrix);

/// The same of every fiber in the strain of the matrix: the lower bound where fibers are stiffer.
[[nodiscard]] Mat6 lower_concentration(const CompositeMaterial& material, double aspect_ratio);

/// Mean stress over mean strain, Pa, when the strain in the fibers is `concentration` times that in the
/// matrix.
[[nodiscard]] Mat6 averaged_stiffness(const CompositeMaterial& material, const Mat6& concentration);

}  // namespace fiberfate
