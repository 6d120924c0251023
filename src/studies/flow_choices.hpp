// What several studies choose about a flow: a Couette rheometer, and the direction of a shear.
#pragma once

#include "base/vector.hpp"
#include "continuum/couette_rheometer.hpp"
#include "keys/key_rows.hpp"

namespace fiberfate {

/// The keys of a Couette rheometer.
[[nodiscard]] KeyRows<CouetteRheometer> couette_rows();
/// The rheometer of the thesis: R_i = 3.5 (R_o - R_i), which gives its shear rates.
inline constexpr CouetteRheometer thesis_rheometer = {0.021, 0.027};

/// The direction along which the velocity of a simple shear varies.
enum class ShearGradient { y, z };
[[nodiscard]] const Choices<ShearGradient>& shear_gradient_choices();
inline constexpr const char* shear_gradient_text = "Direction along which the velocity of a shear varies.";
/// The velocity gradient of simple shear along x, 1/s.
[[nodiscard]] Mat3 shear_gradient(ShearGradient direction, double rate);

}  // namespace fiberfate
