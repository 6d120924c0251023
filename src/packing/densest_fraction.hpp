// How densely fibers can be packed.
#pragma once

#include "base/constants.hpp"
#include "base/vector.hpp"

namespace fiberfate {

/// Volume fraction of parallel cylinders on a hexagonal lattice, pi / sqrt(12): no fibers fill more.
inline constexpr double densest_parallel = 0.9068996821171089;
/// Volume fraction of three perpendicular sets of parallel cylinders.
inline constexpr double densest_crossed = 3 * pi / 16;

/// Largest volume fraction that fibers with this A2 are known to fill: densest_parallel for parallel ones,
/// densest_crossed for isotropic ones, between them linear in the largest eigenvalue. Not a theorem, but well
/// beyond what any packing reaches.
[[nodiscard]] double densest_fraction(const Mat3& orientation);

}  // namespace fiberfate
