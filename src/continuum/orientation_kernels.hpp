// Declares the orientation kernels of each instruction set.
#pragma once

#include "base/kernels.hpp"
#include "continuum/orientation_points.hpp"

namespace fiberfate {

/// Writes DA/Dt of every point to `result`.
FIBERFATE_DECLARE_KERNEL(void evaluate_orientation(const OrientationModel& model,
                                                   const OrientationPoints& points))
/// Writes A2 after the step to `result`; false when some points needed more internal steps than allowed.
FIBERFATE_DECLARE_KERNEL(bool advance_orientation(const OrientationModel& model,
                                                  const OrientationPoints& points,
                                                  const OrientationStep& step))

}  // namespace fiberfate
