// What parameters and fibers must be so that they can be stepped.
#pragma once

#include "dynamics/parameters.hpp"
#include "fibers/state.hpp"
#include "microstructure/flow_history.hpp"

namespace fiberfate {

/// Checks that the laws exist, constants are finite and in their bounds, and steps can be made; raises
/// InputError otherwise.
void require_admissible(const DynamicsParameters& parameters);

/// Checks that a state is sound and its fibers are of the kind that can be stepped: rods longer than thick,
/// fibers not hundreds of times as long as the cell; raises InputError otherwise.
void require_simulable(const FiberState& state);

/// Checks that a flow can carry a cell: steps of simple shear u_x(y) in a matrix that has a viscosity; raises
/// InputError otherwise.
void require_simulable(const FlowHistory& flow);

}  // namespace fiberfate
