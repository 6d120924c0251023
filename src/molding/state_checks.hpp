// Checks that a saved state belongs to a part and its parameters, and is one that a filling can have.
#pragma once

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"

namespace fiberfate {

/// Compares a state with an empty one of the same part and parameters. Raises InputError that names every
/// member at fault: arrays of another size, numbers that are not finite or out of range (filled shares
/// outside of 0 to 1, temperatures or times below 0), gates, events and marks that there are not.
void check_state(const FillingState& state, const FillingState& empty, const FillingParams& params);

}  // namespace fiberfate
