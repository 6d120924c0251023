// Reads and writes orientation tensors in case files.
#pragma once

#include <string>

#include "base/vector.hpp"
#include "keys/key_value.hpp"

namespace fiberfate {

/// Reads a second-order orientation tensor: "isotropic" (1/3, 1/3, 1/3), "planar" (1/2, 1/2, 0: in the plane
/// of flow and gradient, thesis section 3.2.1), "aligned" (1, 0, 0), three principal values along x, y and z,
/// or 3×3 components. A trace within 0.002 of 1 is taken for rounding and scaled to 1.
[[nodiscard]] Reading<Mat3> read_orientation(const TomlValue& value);

/// Writes a tensor: three values where it is diagonal, else 3×3.
[[nodiscard]] std::string write_orientation(const Mat3& tensor, NumberStyle style);

}  // namespace fiberfate
