// How long a shear_cell run takes.
#pragma once

#include <optional>

#include "studies/shear_cell/case.hpp"

namespace fiberfate {

/// How much fibers are in each other's way.
struct Crowding {
  double volume_fraction = 0;
  double aspect_ratio = 1;  ///< mean length over diameter
};
[[nodiscard]] Crowding crowding(const ShearCellCase& values, const SamplePlan& plan);

/// Foretells the time steps of a run: those of its fixed step, or of error control.
[[nodiscard]] double expected_steps(const ShearCellCase& values, const Crowding& fibers);

/// Foretells the wall seconds of a run from a trial of a fraction of a second: of its own first steps where
/// the fibers are there at once, else of steps of some like them.
[[nodiscard]] double shear_cell_seconds(const ShearCellCase& values, const std::optional<SamplePlan>& plan);

}  // namespace fiberfate
