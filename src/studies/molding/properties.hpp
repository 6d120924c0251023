// Properties of a filled part as its case gives them, and their frame.
#pragma once

#include <vector>

#include "io/poly_frame.hpp"
#include "molding/part_properties.hpp"
#include "studies/molding/fields.hpp"

namespace fiberfate {

/// Whether a case gives what properties need: an orientation law and lengths.
[[nodiscard]] bool has_properties(const MoldingCase& values);
/// Takes from a case what its part is made of.
[[nodiscard]] PartSolid solid_of(const MoldingCase& values);

/// Makes a frame of the properties.
[[nodiscard]] PolyFrame properties_frame(const Filling& filling,
                                         const std::vector<TriangleProperties>& properties);

}  // namespace fiberfate
