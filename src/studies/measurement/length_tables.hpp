// The laws fitted to measured lengths, their curves beside the lengths themselves, and quantiles.
#pragma once

#include "microstructure/length_statistics.hpp"
#include "results/outcome.hpp"

namespace fiberfate {

/// Adds the constants of the laws to the summary, and the tables length_curves and quantiles. The bins are
/// those of the histogram, all of one width.
void append_distributions(const MeasuredLengths& fibers, const std::vector<double>& bins, Outcome& outcome);

}  // namespace fiberfate
