// What a state of fibers must be before anything is computed with it.
#pragma once

#include "fibers/state.hpp"

namespace fiberfate {

/// Checks that all numbers of a state are finite, the cell has a volume, and every rod a length and a
/// material with a radius; raises InputError that names the fiber.
void require_sound(const FiberState& state);

/// Checks that no fiber is more than `most` times as long as the cell is high in a periodic direction, so
/// that images can be told apart; raises InputError that names the fiber.
void require_few_images(const FiberState& state, double most);

}  // namespace fiberfate
