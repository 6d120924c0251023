// The mathematical constants that the models use.
#pragma once

#include <numbers>

namespace fiberfate {

inline constexpr double pi = std::numbers::pi;

}  // namespace fiberfate
