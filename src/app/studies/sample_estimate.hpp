// Foretells what the fibers at the start are and what they need.
#pragma once

#include <optional>

#include "app/studies/sample_case.hpp"
#include "app/study.hpp"

namespace fiberfate {

/// Lists what follows from the sample, with the memory that its rods take.
[[nodiscard]] CaseEstimate estimate_sample(const SampleCase& sample, const std::optional<SamplePlan>& plan);

}  // namespace fiberfate
