// How fast this machine steps fibers that are as long and as crowded as those of a sample.
#pragma once

#include "dynamics/parameters.hpp"
#include "studies/sample/case.hpp"

namespace fiberfate {

/// The wall seconds that a rod takes in a step, measured within a fraction of a second on some two thousand
/// rods at most, and with the threads that are in use. They lie at random, as thick, long and dense as those
/// of the sample: that costs about as much as what a packing or a flow makes of them.
[[nodiscard]] double seconds_a_rod_step(const SampleCase& sample, const ContactParameters& contact,
                                        std::uint64_t seed);
/// The same of given fibers.
[[nodiscard]] double seconds_a_rod_step(FiberState fibers, const ContactParameters& contact);

}  // namespace fiberfate
