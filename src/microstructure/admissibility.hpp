// Says whether an orientation tensor belongs to some distribution of directions, and finds the nearest one
// that does.
#pragma once

#include <string>

#include "base/vector.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Says what is wrong with A2, or nothing: it must be finite, symmetric, of unit trace and without negative
/// principal value, each within `tolerance`.
[[nodiscard]] std::string fault_of(const Mat3& second, double tolerance = 1e-9);

/// Says what is wrong with A4, or nothing: symmetric in all four indices, A_ijkk the given A2, and X:A4:X >=
/// 0 for every symmetric X (a fourth moment is a sum of squares), each within `tolerance`.
[[nodiscard]] std::string fault_of(const Mat6& fourth, const Mat3& second, double tolerance = 1e-9);

/// Finds the admissible A2 nearest to a symmetric tensor in the Frobenius norm: the axes stay, the principal
/// values go to the nearest point of the triangle a_i >= 0, sum a_i = 1. Admissible tensors come back
/// unchanged to round-off.
[[nodiscard]] Mat3 nearest_admissible(const Mat3& tensor);

}  // namespace fiberfate
