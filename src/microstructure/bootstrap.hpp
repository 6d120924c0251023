// Draws bootstrap samples and reads percentiles from their statistics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace fiberfate {

/// An estimate and the limits between which it lies with the wanted probability.
struct Interval {
  double estimate = 0;
  double lower = 0;
  double upper = 0;
};

/// How bootstrap samples are drawn and read.
struct Resampling {
  double level = 0.95;  ///< probability of each interval, 0 to 1
  int samples = 1000;
  std::uint64_t seed = 0;
  std::function<void()> before_sample = {};  ///< may throw to end it
};

/// Draws how often each of `count` items occurs in bootstrap sample `sample` of a seed: `count` draws
/// with replacement, the same wherever they are made.
void draw_counts(std::vector<int>& counts, std::size_t count, int sample, std::uint64_t seed);

/// Calls visit(counts) for every sample of `count` items.
template <class Visit>
void visit_samples(std::size_t count, const Resampling& resampling, const Visit& visit) {
  std::vector<int> counts;
  for (int sample = 0; sample < resampling.samples; ++sample) {
    if (resampling.before_sample) resampling.before_sample();
    draw_counts(counts, count, sample, resampling.seed);
    visit(counts);
  }
}

/// Reads the quantiles (1 - level)/2 and (1 + level)/2 of values by linear interpolation between order
/// statistics. Raises InputError for no values, or a level outside 0 to 1.
[[nodiscard]] Interval percentile_interval(double estimate, std::vector<double> values, double level);

}  // namespace fiberfate
