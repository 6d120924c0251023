// Averages and counts populations of fibers.
#include "continuum/length_classes.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/error.hpp"

namespace fiberfate {

void LengthClasses::check() const {
  if (lengths.empty()) throw InputError("a length distribution is empty", "give at least one length");
  if (lengths.size() != numbers.size())
    throw InputError("a length distribution has not as many numbers as lengths", "give one number a length");
  double sum = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (!(lengths[i] > 0) || !std::isfinite(lengths[i]))
      throw InputError("a length distribution has a length that is not positive", "give lengths above zero");
    if (!(numbers[i] >= 0) || !std::isfinite(numbers[i]))
      throw InputError("a length distribution has a negative number of fibers",
                       "give numbers of at least zero");
    sum += numbers[i];
  }
  if (!(sum > 0))
    throw InputError("a length distribution has no fibers", "give at least one number above zero");
}

MeanLengths mean_lengths(std::span<const double> lengths, std::span<const double> numbers) {
  assert(lengths.size() == numbers.size());
  double number = 0, length = 0, square = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    number += numbers[i];
    length += numbers[i] * lengths[i];
    square += numbers[i] * lengths[i] * lengths[i];
  }
  return {length / number, square / length};
}

double total_length(const LengthClasses& classes) {
  double sum = 0;
  for (std::size_t i = 0; i < classes.lengths.size(); ++i) sum += classes.numbers[i] * classes.lengths[i];
  return sum;
}

std::vector<double> histogram(const LengthClasses& classes, std::span<const double> edges) {
  assert(edges.size() >= 2 && std::is_sorted(edges.begin(), edges.end()));
  std::vector<double> counts(edges.size() - 1, 0.0);
  for (std::size_t i = 0; i < classes.lengths.size(); ++i) {
    const double length = classes.lengths[i];
    if (length < edges.front() || length > edges.back()) continue;
    const auto above = std::upper_bound(edges.begin(), edges.end(), length) - edges.begin();
    const auto bin = std::min(static_cast<std::size_t>(above) - 1, counts.size() - 1);
    counts[bin] += classes.numbers[i];
  }
  return counts;
}

}  // namespace fiberfate
