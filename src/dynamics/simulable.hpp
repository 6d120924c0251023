// What parameters and fibers must be so that they can be stepped.
#pragma once

#include "dynamics/parameters.hpp"
#include "fibers/state.hpp"

namespace fiberfate {

/// Checks that the laws exist, constants are finite and in their bounds, and steps can be made; raises
/// InputError otherwise.
void require_admissible(const DynamicsParameters& parameters);

/// Checks that a state is sound and its fibers are of the kind that can be stepped: rods longer than thick,
/// fibers not hundreds of times as long as the cell; raises InputError otherwise.
void require_simulable(const FiberState& state);

}  // namespace fiberfate
