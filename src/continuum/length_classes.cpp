// Averages and counts populations of fibers.
#include "continuum/length_classes.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "base/rising.hpp"

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
  require_same_size("numbers", numbers.size(), lengths.size());
  require_numbers("lengths", lengths, not_negative);
  require_numbers("numbers", numbers, not_negative);
  double number = 0, length = 0, square = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    number += numbers[i];
    length += numbers[i] * lengths[i];
    square += numbers[i] * lengths[i] * lengths[i];
  }
  if (!(length > 0))
    throw InputError("a length distribution has no fibers", "give at least one number above zero");
  return {length / number, square / length};
}

double total_length(const LengthClasses& classes) {
  double sum = 0;
  for (std::size_t i = 0; i < classes.lengths.size(); ++i) sum += classes.numbers[i] * classes.lengths[i];
  return sum;
}

namespace {

void count_in_bin(double length, double number, std::span<const double> edges, std::vector<double>& counts) {
  if (length < edges.front() || length > edges.back()) return;
  const auto above = std::upper_bound(edges.begin(), edges.end(), length) - edges.begin();
  const auto bin = std::min(above, std::ssize(counts)) - 1;
  counts[bin] += number;
}

void spread_over_bins(double from, double to, double number, std::span<const double> edges,
                      std::vector<double>& counts) {
  const auto above = std::upper_bound(edges.begin(), edges.end(), from) - edges.begin();
  for (auto bin = std::max<std::ptrdiff_t>(above - 1, 0); bin < std::ssize(counts) && edges[bin] < to;
       ++bin) {
    const double inside = std::min(to, edges[bin + 1]) - std::max(from, edges[bin]);
    if (inside > 0) counts[bin] += number * inside / (to - from);
  }
}

}  // namespace

std::vector<double> histogram(const LengthClasses& classes, std::span<const double> edges) {
  if (edges.size() < 2 || !are_rising(edges))
    throw InputError("the edges of the bins do not rise", "give at least two edges in rising order");
  require_same_size("numbers", classes.numbers.size(), classes.lengths.size());
  std::vector<double> counts(edges.size() - 1, 0.0);
  const double longest = classes.lengths.empty() ? 0 : std::ranges::max(classes.lengths);
  for (std::size_t i = 0; i < classes.lengths.size(); ++i) {
    const double length = classes.lengths[i], number = classes.numbers[i];
    const double from = length - 0.5 * classes.width, to = std::min(length + 0.5 * classes.width, longest);
    if (to > from)
      spread_over_bins(from, to, number, edges, counts);
    else
      count_in_bin(length, number, edges, counts);
  }
  return counts;
}

}  // namespace fiberfate
