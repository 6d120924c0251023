// Writes what a filling came to: values at places, profiles across the gap, the sweep, the summary.
#pragma once

#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/molding/checkpoint.hpp"
#include "studies/molding/fields.hpp"

namespace fiberfate {

/// Writes places.csv, profiles.csv, histogram.csv and sweep.csv, and adds the keys of the study to the
/// summary.
void write_outcome(const MoldingFields& fields, const MoldingRecord& record, const ResultFolder& folder,
                   RunSummary& summary);

}  // namespace fiberfate
