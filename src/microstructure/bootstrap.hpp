// Draws bootstrap samples and reads percentiles from their statistics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fiberfate {

/// An estimate and the limits between which it lies with the wanted probability.
struct Interval {
  double estimate = 0;
  double lower = 0;
  double upper = 0;
};

/// Draws how often each of `count` items occurs in bootstrap sample `sample` of a seed: `count` draws
/// with replacement, the same wherever they are made.
void draw_counts(std::vector<int>& counts, std::size_t count, int sample, std::uint64_t seed);

/// Reads the quantiles (1 - level)/2 and (1 + level)/2 of values by linear interpolation between order
/// statistics. Raises InputError for no values, or a level outside 0 to 1.
[[nodiscard]] Interval percentile_interval(double estimate, std::vector<double> values, double level);

}  // namespace fiberfate
