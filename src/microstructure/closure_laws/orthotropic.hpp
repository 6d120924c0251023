// What the fitted orthotropic closures share.
#pragma once

namespace fiberfate {

/// The fits give A1111, A2222, A3333 in the principal frame as polynomials of the two largest principal
/// values x and y, written with these fifteen powers, the later ones absent (zero) where an order is lower:
///   1, x, y, xy, x², y², x²y, xy², x³, y³, x²y², x³y, xy³, x⁴, y⁴
/// Coefficients are the published ones, digit for digit.
inline constexpr int orthotropic_terms = 15;
using OrthotropicCoefficients = double[3][orthotropic_terms];

}  // namespace fiberfate
