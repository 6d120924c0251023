// What several studies choose about a flow: a Couette rheometer, the direction of a shear, gradients in
// tables.
#pragma once

#include <cstddef>
#include <vector>

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

/// The columns L11, L12, … L33 of a velocity gradient in a table.
[[nodiscard]] std::vector<Column> gradient_columns();
/// The velocity gradient of nine such numbers of a row, from a place on, 1/s.
[[nodiscard]] Mat3 row_gradient(const std::vector<double>& row, std::size_t first);

}  // namespace fiberfate
