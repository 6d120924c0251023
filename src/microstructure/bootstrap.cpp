// Resamples with counter-based random numbers.
#include "microstructure/bootstrap.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "base/random.hpp"

namespace fiberfate {
namespace {

double quantile(const std::vector<double>& sorted, double probability) {
  const double place = probability * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - std::floor(place));
}

}  // namespace

void draw_counts(std::vector<int>& counts, std::size_t count, int sample, std::uint64_t seed) {
  counts.assign(count, 0);
  for (std::size_t i = 0; i < count; i += 4) {
    const auto numbers = uniform4(seed, RandomStream::bootstrap,
                                  {static_cast<std::uint32_t>(sample), static_cast<std::uint32_t>(i / 4)});
    for (std::size_t k = 0; k < 4 && i + k < count; ++k)
      ++counts[static_cast<std::size_t>(numbers[k] * static_cast<double>(count))];
  }
}

Interval percentile_interval(double estimate, std::vector<double> values, double level) {
  require_number("level", level, {.lower = 0, .upper = 1 - 1e-12, .above_lower = true});
  if (values.empty()) throw InputError("there is nothing to take percentiles of", "resample at least once");
  std::ranges::sort(values);
  return {estimate, quantile(values, 0.5 * (1 - level)), quantile(values, 0.5 * (1 + level))};
}

}  // namespace fiberfate
