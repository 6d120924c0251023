// The constants that the models use.
#pragma once

#include <numbers>

namespace fiberfate {

inline constexpr double pi = std::numbers::pi;
inline constexpr double zero_celsius = 273.15;  ///< K

}  // namespace fiberfate
