// Averages, bins and resamples measured lengths.
#include "microstructure/length_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "base/rising.hpp"

namespace fiberfate {
namespace {

void require_usable(const MeasuredLengths& fibers) {
  if (fibers.lengths.empty()) throw InputError("the list of lengths is empty", "give at least one fiber");
  if (!fibers.numbers.empty() && fibers.numbers.size() != fibers.lengths.size())
    throw InputError(
        fmt::format("there are {} numbers for {} lengths", fibers.numbers.size(), fibers.lengths.size()),
        "give one number a length, or none");
  double sum = 0;
  for (std::size_t i = 0; i < fibers.lengths.size(); ++i) {
    if (!(fibers.lengths[i] > 0) || !std::isfinite(fibers.lengths[i]))
      throw InputError(fmt::format("length {} of the list is {:g} m", i + 1, fibers.lengths[i]),
                       "lengths are positive");
    if (!(number_of(fibers, i) >= 0) || !std::isfinite(number_of(fibers, i)))
      throw InputError(fmt::format("number {} of the list is {:g}", i + 1, number_of(fibers, i)),
                       "numbers are not negative");
    sum += number_of(fibers, i);
  }
  if (!(sum > 0)) throw InputError("all numbers are zero", "give at least one fiber");
}

/// Sums N, N L and N L².
struct Sums {
  double count = 0, length = 0, square = 0;
  void add(double number, double size) {
    count += number;
    length += number * size;
    square += number * size * size;
  }
};

Sums sums_of(const MeasuredLengths& fibers) {
  require_usable(fibers);
  Sums sums;
  for (std::size_t i = 0; i < fibers.lengths.size(); ++i) sums.add(number_of(fibers, i), fibers.lengths[i]);
  return sums;
}

/// The bin of a length, or as many as there are bins for one outside the edges.
std::size_t bin_of(double length, const std::vector<double>& edges) {
  if (length < edges.front() || length > edges.back()) return edges.size() - 1;
  const auto above = std::ranges::upper_bound(edges, length) - edges.begin();
  return std::min(above, std::ssize(edges) - 1) - 1;
}

void normalise(std::vector<double>& shares) {
  double sum = 0;
  for (const double share : shares) sum += share;
  if (sum > 0)
    for (double& share : shares) share /= sum;
}

}  // namespace

MeasuredLengths corrected_for_sampling(const MeasuredLengths& measured, double sample_diameter) {
  require_usable(measured);
  if (!(sample_diameter > 0) || !std::isfinite(sample_diameter))
    throw InputError(fmt::format("a sample of diameter {:g} m is impossible", sample_diameter),
                     "give the diameter of the down-sampled region");
  MeasuredLengths corrected = measured;
  corrected.numbers.resize(measured.lengths.size());
  for (std::size_t i = 0; i < measured.lengths.size(); ++i)
    corrected.numbers[i] = number_of(measured, i) / (1 + 4 * measured.lengths[i] / (pi * sample_diameter));
  return corrected;
}

double number_average(const MeasuredLengths& fibers) {
  const Sums sums = sums_of(fibers);
  return sums.length / sums.count;
}

double weight_average(const MeasuredLengths& fibers) {
  const Sums sums = sums_of(fibers);
  return sums.square / sums.length;
}

LengthShares length_shares(const MeasuredLengths& fibers, const std::vector<double>& edges) {
  require_usable(fibers);
  if (edges.size() < 2 || !are_rising(edges))
    throw InputError("the edges of the bins do not rise", "give at least two edges in rising order");
  LengthShares shares{edges, std::vector<double>(edges.size() - 1), std::vector<double>(edges.size() - 1)};
  for (std::size_t i = 0; i < fibers.lengths.size(); ++i) {
    const std::size_t bin = bin_of(fibers.lengths[i], edges);
    if (bin == shares.by_number.size()) continue;
    shares.by_number[bin] += number_of(fibers, i);
    shares.by_length[bin] += number_of(fibers, i) * fibers.lengths[i];
  }
  normalise(shares.by_number);
  normalise(shares.by_length);
  return shares;
}

std::vector<double> share_deviations(const MeasuredLengths& fibers, const LengthShares& shares) {
  require_usable(fibers);
  const std::size_t bins = shares.by_number.size();
  require_same_size("shares.edges", shares.edges.size(), bins + 1);
  std::vector<double> squares(bins, 0.0);  // of the numbers in each bin
  double square = 0, sum = 0, rows = 0;
  for (std::size_t i = 0; i < fibers.lengths.size(); ++i) {
    const std::size_t bin = bin_of(fibers.lengths[i], shares.edges);
    if (bin == bins) continue;
    const double number = number_of(fibers, i);
    squares[bin] += number * number;
    square += number * number;
    sum += number;
    ++rows;
  }
  std::vector<double> deviations(bins);
  for (std::size_t k = 0; k < bins; ++k) {
    const double share = shares.by_number[k];
    const double variance = squares[k] * (1 - share) * (1 - share) + (square - squares[k]) * share * share;
    deviations[k] = std::sqrt(std::max(variance, square / rows)) / sum;
  }
  return deviations;
}

std::vector<double> even_edges(const MeasuredLengths& fibers, int bins) {
  require_usable(fibers);
  if (bins < 1) throw InputError(fmt::format("{} bins hold nothing", bins), "take at least one");
  const double longest = std::ranges::max(fibers.lengths);
  std::vector<double> edges(bins + 1);
  for (std::size_t k = 0; k < edges.size(); ++k) edges[k] = longest * static_cast<double>(k) / bins;
  edges.back() = longest;
  return edges;
}

LengthIntervals bootstrap_mean_lengths(const MeasuredLengths& fibers, const Resampling& resampling) {
  require_usable(fibers);
  std::vector<double> number_averages, weight_averages;
  visit_samples(fibers.lengths.size(), resampling, [&](const std::vector<int>& counts) {
    Sums sums;
    for (std::size_t i = 0; i < fibers.lengths.size(); ++i)
      sums.add(counts[i] * number_of(fibers, i), fibers.lengths[i]);
    if (!(sums.length > 0)) return;  // only fibers of number zero were drawn
    number_averages.push_back(sums.length / sums.count);
    weight_averages.push_back(sums.square / sums.length);
  });
  return {percentile_interval(number_average(fibers), number_averages, resampling.level),
          percentile_interval(weight_average(fibers), weight_averages, resampling.level)};
}

}  // namespace fiberfate
