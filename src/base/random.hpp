// Draws random numbers that are a pure function of what they are for: threads, ranks and restarts change
// nothing.
#pragma once

#include <array>
#include <cstdint>

namespace fiberfate {

/// The purposes of random numbers, so that two uses with equal counters stay independent.
/// The values are part of the reproducibility contract: append, never renumber.
enum class RandomStream : std::uint32_t {
  orientation = 1,
  position = 2,
  length = 3,
  hinge_strength = 4,
  breakage = 5,
  bootstrap = 6,
  noise = 7,
};

/// Identifies one draw within a stream.
struct RandomCounter {
  std::uint32_t first = 0;   ///< e.g. birth id of the fiber
  std::uint32_t second = 0;  ///< e.g. material position along it
  std::uint32_t third = 0;   ///< e.g. number of the check
};

/// Draws four independent numbers, uniform in the open interval (0, 1), by Philox4x32-10 keyed with (seed,
/// stream). Source: Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011).
[[nodiscard]] std::array<double, 4> uniform4(std::uint64_t seed, RandomStream stream, RandomCounter counter);

/// Draws one number, uniform in (0, 1): the first of uniform4.
[[nodiscard]] double uniform(std::uint64_t seed, RandomStream stream, RandomCounter counter);

/// Draws two independent standard normal numbers (Box-Muller on uniform4).
[[nodiscard]] std::array<double, 2> normal2(std::uint64_t seed, RandomStream stream, RandomCounter counter);

}  // namespace fiberfate
