// Whether an orientation tensor belongs to some distribution of directions, and the nearest one
// that does.
#pragma once

#include <string>

#include "base/vector.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// What is wrong with A2, or nothing: it must be finite, symmetric, of unit trace and without negative
/// principal value, each within `tolerance`.
[[nodiscard]] std::string fault_of(const Mat3& second, double tolerance = 1e-9);

/// Checks that some distribution of directions has this second moment: finite, symmetric, of unit trace,
/// without negative principal value, each within `tolerance`. Raises InputError that says what is wrong and
/// which tensor would be possible.
void require_admissible(const Mat3& second, double tolerance = 1e-6);

/// Departure from an admissible A2 that a law forgives in what a solver hands it: single precision and
/// interpolation between nodes lead this far. More is a mistake, and is refused.
inline constexpr double forgiven_departure = 1e-3;

/// Raises InputError, as require_admissible, for a state that no law takes. Costs little for one that it
/// does.
void require_forgivable(const Mat3& second);

/// What is wrong with A4, or nothing: symmetric in all four indices, A_ijkk the given A2, and X:A4:X >=
/// 0 for every symmetric X (a fourth moment is a sum of squares), each within `tolerance`.
[[nodiscard]] std::string fault_of(const Mat6& fourth, const Mat3& second, double tolerance = 1e-9);

/// Finds the admissible A2 nearest to a symmetric tensor in the Frobenius norm: the axes stay, the principal
/// values go to the nearest point of the triangle a_i >= 0, sum a_i = 1. Admissible tensors come back
/// unchanged to round-off.
[[nodiscard]] Mat3 nearest_admissible(const Mat3& tensor);

}  // namespace fiberfate
