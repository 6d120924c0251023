// Frames of fillings: the part over time, and its layers.
#pragma once

#include "io/poly_frame.hpp"
#include "io/prism_file.hpp"
#include "studies/molding/fields.hpp"

namespace fiberfate {

/// Makes a frame of the part's triangles and the present time, without data.
[[nodiscard]] PolyFrame shell_frame(const Filling& filling);

/// Makes a frame of the present state (docs/formats/results.md); the first has the geometry, later ones share
/// it.
[[nodiscard]] PolyFrame part_frame(const MoldingFields& fields, FrameGeometry geometry);

/// Gives the last state by layers: prisms between the middles of the layers, from wall to wall, with
/// temperature, shear rate, orientation and lengths at their corners.
[[nodiscard]] PrismMesh layer_prisms(const MoldingFields& fields);

}  // namespace fiberfate
