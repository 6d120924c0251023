// What a filling has kept of what came in, and how its fibers lie on the whole.
#pragma once

#include "molding/filling.hpp"

namespace fiberfate {

/// The volume that was lost or made, over that of the part: (injected − held)/V.
[[nodiscard]] double volume_error(const Filling& filling);
/// The heat that was lost or made, over that which came in and was made by flow.
[[nodiscard]] double heat_error(const Filling& filling);
/// Averages A2 over all melt, in the axes of the part; NaN where there is none.
[[nodiscard]] Mat3 part_orientation(const Filling& filling);
/// Counts the nodes that have a mark.
[[nodiscard]] std::int64_t count_marks(const FillingState& state, NodeMark mark);

}  // namespace fiberfate
