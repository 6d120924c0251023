// Checks that a saved state belongs to a part and its parameters, and is one that a filling can have.
#pragma once

#include <vector>

#include "molding/filling_state.hpp"

namespace fiberfate {

/// How large the arrays of a state are.
struct StateShape {
  std::size_t nodes = 0;
  std::size_t layers = 0;      ///< of half the gap
  std::size_t components = 0;  ///< of the orientation: 6, or 0 where none is followed
  std::size_t fields = 0;      ///< of lengths and amounts, by point
  std::size_t sensors = 0;
  std::vector<int> most_moves = {};  ///< by gate: how often it opens and closes at most
};

/// Raises InputError that names every member of a state at fault, as "state/filled": arrays of another size,
/// numbers that are not finite or out of range (filled shares outside of 0 to 1, temperatures or times below
/// 0), ends, controls, events and marks that there are not.
void check_state(const FillingState& state, const StateShape& shape);

}  // namespace fiberfate
