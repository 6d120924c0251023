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

/// Checks that fibers can follow a flow: it goes in steps, in a matrix that has a viscosity; raises
/// InputError otherwise.
void require_simulable(const FlowHistory& flow);

/// Checks that a cell can follow a flow for ever (lattice_choice.hpp), along its walls where it has any;
/// raises InputError otherwise.
void require_flow(const Cell& cell, const FlowHistory& flow);

}  // namespace fiberfate
