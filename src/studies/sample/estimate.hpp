// Foretells what the fibers at the start are and what they need.
#pragma once

#include <optional>

#include "studies/sample/case.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Lists what follows from the sample, with the memory that its rods take.
[[nodiscard]] CaseEstimate estimate_sample(const SampleCase& sample, const std::optional<SamplePlan>& plan);

}  // namespace fiberfate
