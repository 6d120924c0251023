// The orientation kernels of each instruction set.
#pragma once

#include "base/kernels.hpp"
#include "continuum/orientation_points.hpp"

namespace fiberfate {

/// Writes DA/Dt of every point to `result`.
FIBERFATE_DECLARE_KERNEL(void evaluate_orientation(const OrientationModel& model,
                                                   const OrientationPoints& points))
/// Writes the rotary diffusion tensor C, without the rate, of every point to `result`.
FIBERFATE_DECLARE_KERNEL(void evaluate_rotary_diffusion(const OrientationModel& model,
                                                        const OrientationPoints& points))
/// The first point whose state or velocity gradient no law takes: not finite, or further than
/// `forgiven` from a state of unit trace without negative principal value; as many as there are when there is
/// none.
FIBERFATE_DECLARE_KERNEL(std::size_t find_orientation_fault(const OrientationPoints& points, double forgiven))
/// Writes A2 after the step to `result` of consecutive points, eight at a time, until eight of them need more
/// internal steps than allowed: these and what follows are left as they are. Returns how many were advanced,
/// and adds to `put_back` how many of them left the admissible states and were put back.
FIBERFATE_DECLARE_KERNEL(std::size_t advance_orientation(const OrientationModel& model,
                                                         const OrientationPoints& points,
                                                         const OrientationStep& step, std::size_t& put_back))

}  // namespace fiberfate
