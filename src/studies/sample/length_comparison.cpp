// Counts fibers by length and what the laws of a case expect in the same bins.
#include "studies/sample/length_comparison.hpp"

#include <algorithm>
#include <numeric>

#include "base/constants.hpp"
#include "studies/sample/fiber_sections.hpp"

namespace fiberfate {
namespace {

constexpr double bins_to_twice_weight_average = 40;
// The law itself, as a stratified sample so large that its own coarseness does not show.
constexpr std::size_t law_sample = 100000;

struct WeightedLengths {
  std::vector<double> lengths;
  double share;  ///< of the number of fibers, relative
};

std::vector<WeightedLengths> laws_of(const SampleCase& sample) {
  std::vector<WeightedLengths> laws;
  for (const FiberSpecies& kind : species(sample)) {
    const double volume = kind.material.radius * kind.material.radius * number_average(kind.length);
    laws.push_back({sample_lengths(kind.length, {law_sample, 1, {}, kind.material.diameter()}),
                    kind.volume_share / volume});
  }
  return laws;
}

void measure_means(const std::vector<WeightedLengths>& laws, LengthComparison& comparison) {
  double number = 0, first = 0, second = 0;
  for (const WeightedLengths& law : laws) {
    for (const double length : law.lengths) {
      number += law.share;
      first += law.share * length;
      second += law.share * length * length;
    }
  }
  comparison.number_average = first / number;
  comparison.weight_average = second / first;
}

void measure_fit(LengthComparison& comparison) {
  // Neighbouring bins are put together until this many fibers are expected: the sum follows chi-square's law
  // only above about that.
  constexpr double fewest = 5;
  double found = 0, expected = 0;
  double left = std::accumulate(comparison.expected.begin(), comparison.expected.end(), 0.0);
  for (std::size_t bin = 0; bin < comparison.found.size(); ++bin) {
    found += comparison.found[bin];
    expected += comparison.expected[bin];
    left -= comparison.expected[bin];
    const bool last = bin + 1 == comparison.found.size();
    if (!(expected > 0) || (!last && std::min(expected, left) < fewest)) continue;
    comparison.chi_square += (found - expected) * (found - expected) / expected;
    ++comparison.chi_square_bins;
    found = expected = 0;
  }
}

}  // namespace

std::vector<KindComparison> compare_kinds(const SampleCase& sample, const FiberState& state) {
  const std::vector<FiberSpecies> kinds = species(sample);
  std::vector<KindComparison> comparisons(kinds.size());
  std::vector<double> squares(kinds.size());
  double volume = 0, shares = 0;
  for (const FiberIndex fiber : state.fibers()) {
    const std::size_t kind = state.material_id[fiber];
    const double radius = kinds.at(kind).material.radius, length = fiber_length(state, fiber);
    ++comparisons[kind].fibers;
    comparisons[kind].number_average += length;
    squares[kind] += length * length;
    comparisons[kind].volume_share += pi * radius * radius * length;
  }
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    KindComparison& one = comparisons[k];
    one.number_average_asked = number_average(kinds[k].length);
    one.weight_average_asked = weight_average(kinds[k].length);
    one.volume_share_asked = kinds[k].volume_share;
    if (one.fibers > 0) one.weight_average = squares[k] / one.number_average;
    if (one.fibers > 0) one.number_average /= static_cast<double>(one.fibers);
    volume += one.volume_share;
    shares += one.volume_share_asked;
  }
  for (KindComparison& one : comparisons) {
    one.volume_share /= volume;
    one.volume_share_asked /= shares;
  }
  return comparisons;
}

LengthComparison compare_lengths(const SampleCase& sample, const std::vector<double>& lengths) {
  LengthComparison comparison;
  const std::vector<WeightedLengths> laws = laws_of(sample);
  measure_means(laws, comparison);
  comparison.edges = sample.fibers.length_histogram.edges;
  const auto [shortest, longest_at] = std::minmax_element(lengths.begin(), lengths.end());
  const double longest = *longest_at;
  // The histogram of one kind need not hold the fibers of another.
  if (comparison.edges.empty() || comparison.edges.back() < longest || comparison.edges.front() > *shortest)
    comparison.edges = bin_edges(longest, 2 * comparison.weight_average / bins_to_twice_weight_average);
  comparison.found = counts(lengths, comparison.edges);
  comparison.expected.assign(comparison.found.size(), 0.0);
  double shares = 0;
  for (const WeightedLengths& law : laws) shares += law.share;
  for (const WeightedLengths& law : laws) {
    const std::vector<double> own = counts(law.lengths, comparison.edges);
    const double scale = static_cast<double>(lengths.size()) * law.share / shares / law_sample;
    for (std::size_t bin = 0; bin < own.size(); ++bin) comparison.expected[bin] += scale * own[bin];
  }
  measure_fit(comparison);
  return comparison;
}

}  // namespace fiberfate
