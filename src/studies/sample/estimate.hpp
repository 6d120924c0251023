// Foretells what the fibers at the start are and what they need.
#pragma once

#include <optional>

#include "studies/sample/case.hpp"
#include "studies/sample/start.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// The memory that packing and stepping a sample take, the program with it; without a plan only the latter.
[[nodiscard]] double sample_bytes(const std::optional<SamplePlan>& plan);
/// Raises InputError where there is not so much.
void require_sample_memory(const SampleCase& sample, std::uint64_t seed);
/// Lists what follows from the sample, with the memory that its rods take.
[[nodiscard]] CaseEstimate estimate_sample(const SampleCase& sample, const std::optional<SamplePlan>& plan);

/// Up to so many rods are packed within a moment, for trial.
inline constexpr std::int64_t most_rods_to_pack = 150;
/// Foretells the wall seconds of packing: from a trial, or from those of a rod in a step of the dynamics.
[[nodiscard]] double packing_seconds(const SampleCase& sample, const StartRequest& start,
                                     const SamplePlan& plan, double seconds_a_rod_step);

}  // namespace fiberfate
