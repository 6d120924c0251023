// What a filling came to: values at places, profiles across the gap, the sweep, the summary.
#pragma once

#include "results/outcome.hpp"
#include "studies/molding/checkpoint.hpp"
#include "studies/molding/fields.hpp"

namespace fiberfate {

/// What a filling came to: tables places, profiles, histogram and sweep, and the study's own keys of
/// the summary.
[[nodiscard]] Outcome gather_outcome(const MoldingFields& fields, const MoldingRecord& record);

}  // namespace fiberfate
