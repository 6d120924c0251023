// Declares the orientation kernels of each instruction set.
#pragma once

#include "continuum/orientation_points.hpp"

namespace fiberfate {

namespace baseline {
/// Writes DA/Dt of every point to `result`.
void evaluate_orientation(const OrientationModel& model, const OrientationPoints& points);
/// Writes A2 after the step to `result`; false when some points needed more internal steps than allowed.
bool advance_orientation(const OrientationModel& model, const OrientationPoints& points,
                         const OrientationStep& step);
}  // namespace baseline
namespace avx2 {
void evaluate_orientation(const OrientationModel& model, const OrientationPoints& points);
bool advance_orientation(const OrientationModel& model, const OrientationPoints& points,
                         const OrientationStep& step);
}  // namespace avx2
namespace avx512 {
void evaluate_orientation(const OrientationModel& model, const OrientationPoints& points);
bool advance_orientation(const OrientationModel& model, const OrientationPoints& points,
                         const OrientationStep& step);
}  // namespace avx512

}  // namespace fiberfate
