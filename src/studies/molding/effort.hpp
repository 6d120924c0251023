// What a filling takes.
#pragma once

#include "studies/molding/setup.hpp"

namespace fiberfate {

/// The memory that a filling takes, the program with it, bytes.
[[nodiscard]] double filling_bytes(const MoldingSetup& setup);

}  // namespace fiberfate
