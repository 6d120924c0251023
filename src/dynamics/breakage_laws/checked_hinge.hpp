// What a law of breakage sees of a hinge.
#pragma once

#include <cstdint>

namespace fiberfate {

/// The name of a hinge for ever: where it lies on the fiber that was there at the beginning.
struct HingeName {
  std::uint32_t birth_id = 0;
  std::uint32_t birth_node = 0;
};

/// Describes a hinge at a check. Draws are to be keyed by seed, name and, where each check draws anew, its
/// number: threads, ranks and restarts then change nothing.
struct CheckedHinge {
  double radius = 0;  ///< of curvature, m
  HingeName name;
  std::int64_t check = 0;  ///< number of the check
  std::uint64_t seed = 0;  ///< of the run
};

}  // namespace fiberfate
