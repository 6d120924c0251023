// Writes fillings as VTKHDF: the part over time, its layers, its stiffness.
#pragma once

#include <string>

#include "io/poly_frame.hpp"
#include "studies/molding/fields.hpp"

namespace fiberfate {

/// Makes a frame of the present state (docs/formats/results.md); the first has the geometry, later ones share
/// it.
[[nodiscard]] PolyFrame part_frame(const MoldingFields& fields, FrameGeometry geometry);

/// Writes the last state by layers: prisms between the middles of the layers, from wall to wall, with
/// temperature, shear rate, orientation and lengths at their corners. Raises StorageError.
void write_layers(const std::string& path, const MoldingFields& fields);

}  // namespace fiberfate
