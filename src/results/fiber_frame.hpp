// Turns fibers into polylines with their numbers, as result.vtkhdf holds them, and back.
#pragma once

#include <string>
#include <vector>

#include "fibers/state.hpp"
#include "io/poly_frame.hpp"

namespace fiberfate {

/// Makes a frame: at points the relative velocity and the curvature, on fibers birth_id, birth_node, length,
/// material and radius, and the lattice of the cell (docs/formats/results.md).
[[nodiscard]] PolyFrame fiber_frame(const FiberState& state);

/// Makes the fibers of a frame again: shapes, cell and origin; of the materials only the radii are known, so
/// one material is made for every radius. Raises StorageError when the frame does not hold fibers.
[[nodiscard]] FiberState fibers_of(const PolyFrame& frame);

/// Finds an array of doubles or floats by name and hands it over as doubles; raises StorageError.
[[nodiscard]] std::vector<double> numbers_of(const std::vector<FrameArray>& arrays, const std::string& name);

}  // namespace fiberfate
