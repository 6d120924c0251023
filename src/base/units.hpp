// Reads quantities with units, "19 um" or "16.65 1/s", into SI numbers, and checks their dimension.
#pragma once

#include <string>
#include <string_view>

namespace fiberfate {

/// Converts a quantity such as "200 Pa s" to a number in the coherent SI unit `si_unit` ("Pa s").
/// A bare number ("0.2") is taken to be in `si_unit`. "%" is 0.01 where `si_unit` is "1".
/// Raises std::invalid_argument with the reason when the number or unit cannot be read or the dimension
/// differs.
[[nodiscard]] double quantity_in_si(std::string_view quantity, const std::string& si_unit);

/// The factor that turns a number in `unit` into one in `si_unit`; raises as above.
[[nodiscard]] double unit_factor(const std::string& unit, const std::string& si_unit);

}  // namespace fiberfate
