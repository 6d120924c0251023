// Finds principal values and axes of symmetric tensors, and says which of them are equal.
#pragma once

#include "base/vector.hpp"

namespace fiberfate {

/// Principal values that differ by less are treated as equal: their axes, wrong by round-off over the
/// difference, would no longer mean anything. The values are those of tensors of unit trace.
inline constexpr double equal_principal_values = 1e-9;

/// Principal values in falling order and their unit axes as the columns of a proper rotation.
struct Eigenframe {
  Vec3 values = Vec3::Zero();
  Mat3 axes = Mat3::Identity();
};

/// Decomposes a symmetric tensor, A = axes · diag(values) · axesᵀ (the lower triangle is read).
[[nodiscard]] Eigenframe eigenframe(const Mat3& tensor);

/// Decomposes a tensor and turns the axes within the space of equal values so that `guide` is diagonal there,
/// in falling order. A spins so that its axes become those of its own rate: at equal values the guide is that
/// rate, or the rate of strain, which is the same for an isotropic state.
[[nodiscard]] Eigenframe eigenframe(const Mat3& tensor, const Mat3& guide);

}  // namespace fiberfate
