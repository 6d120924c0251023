// Draws fiber lengths from one value, a histogram, a list, or a Weibull or log-normal law with given mean
// lengths.
#include "microstructure/length_distribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "base/random.hpp"
#include "base/rising.hpp"

namespace fiberfate {
namespace {

// Most that the mean length may leave that of the law so that the total comes out: realised means keep within
// 0.5 %.
constexpr double most_adjustment = 0.0049;

/// More rods a fiber than any cell holds.
constexpr double most_rods = 1e8;

// Rows of random counters, so that the uses of the length stream stay independent.
enum Draw : std::uint32_t { place_draw = 0, deal_draw = 1 };

double draw(std::uint64_t seed, std::size_t i, Draw which) {
  return uniform(seed, RandomStream::length, {static_cast<std::uint32_t>(i), which, 0});
}

void deal(std::vector<double>& lengths, std::uint64_t seed) {
  for (std::size_t i = lengths.size(); i > 1; --i)
    std::swap(lengths[i - 1],
              lengths[static_cast<std::size_t>(draw(seed, i, deal_draw) * static_cast<double>(i))]);
}

double mean(const std::vector<double>& lengths) {
  return std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(lengths.size());
}

double weight_mean(const std::vector<double>& lengths) {
  return std::inner_product(lengths.begin(), lengths.end(), lengths.begin(), 0.0) /
         std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

void require_positive(double length, const char* what) {
  if (!(length > 0) || !std::isfinite(length))
    throw InputError(fmt::format("{} is {:.4g} m", what, length), "give a length above zero");
}

void require_means(double number, double weight) {
  require_positive(number, "the number average length");
  require_positive(weight, "the weight average length");
  if (weight < number)
    throw InputError(fmt::format("the weight average length {:.4g} m is below the number average {:.4g} m",
                                 weight, number),
                     "L_W is never below L_N; exchange them, or give a single length");
  // Broader laws than this put nearly all volume in fibers that no finite sample contains.
  constexpr double broadest = 20;
  if (weight > broadest * number)
    throw InputError(fmt::format("L_W / L_N is {:.4g}", weight / number),
                     fmt::format("give at most {}", broadest));
}

/// Shares of the number of fibers, one a bin.
std::vector<double> number_shares(const LengthHistogram& histogram) {
  std::vector<double> shares(histogram.heights);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double middle = 0.5 * (histogram.edges[i] + histogram.edges[i + 1]);
    if (histogram.height == HistogramHeight::length) shares[i] /= middle;
  }
  const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share /= total;
  return shares;
}

/// Fibers in each bin: the running total of the shares rounded, so that every bin is within one fiber of its
/// share.
std::vector<std::size_t> bin_counts(const std::vector<double>& shares, std::size_t count) {
  std::vector<std::size_t> counts(shares.size());
  double reached = 0;
  std::size_t given = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    reached += shares[i];
    const bool last = i + 1 == shares.size();
    const auto upto =
        last ? count
             : std::min(count, static_cast<std::size_t>(std::llround(reached * static_cast<double>(count))));
    counts[i] = upto - given;
    given = upto;
  }
  return counts;
}

/// How many lengths are drawn, and their mean.
struct Draft {
  std::size_t count;
  double mean;      ///< m
  double shortest;  ///< m
  std::uint64_t seed;
};

/// Middle of one of `count` equal strata of the unit interval.
double stratum(std::size_t i, std::size_t count) {
  return (static_cast<double>(i) + 0.5) / static_cast<double>(count);
}

/// Solves f(x) = 0 for a rising f with f(low) <= 0 <= f(high).
double bisect(const std::function<double(double)>& rising, double low, double high) {
  constexpr int most_halvings = 100;  // a root at zero would be halved for ever
  double middle = 0.5 * (low + high);
  for (int i = 0; i < most_halvings && middle != low && middle != high; ++i) {
    (rising(middle) > 0 ? high : low) = middle;
    middle = 0.5 * (low + high);
  }
  return middle;
}

/// Lengths of a histogram whose bins hold `counts` fibers, each bin evenly spread but for u^`tilt` on its way
/// from edge to edge.
std::vector<double> fill_bins(const LengthHistogram& histogram, const std::vector<std::size_t>& counts,
                              double shortest, double tilt) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double width = histogram.edges[i + 1] - histogram.edges[i];
    for (std::size_t k = 0; k < counts[i]; ++k)
      lengths.push_back(
          std::max(shortest, histogram.edges[i] + width * std::pow(stratum(k, counts[i]), tilt)));
  }
  return lengths;
}

// The bins keep their counts; the mean is met by moving fibers inside them, up to twice as many above the
// middle as below.
std::vector<double> sample(const LengthHistogram& histogram, const Draft& draft) {
  const std::vector<std::size_t> counts = bin_counts(number_shares(histogram), draft.count);
  const double tilt = bisect(
      [&](double exponent) {
        return draft.mean - mean(fill_bins(histogram, counts, draft.shortest, exponent));
      },
      0.5, 2);
  return fill_bins(histogram, counts, draft.shortest, tilt);
}

std::vector<double> sample(const SingleLength& single, const Draft& draft) {
  return std::vector<double>(draft.count, single.length);
}

/// Takes `count` of sorted lengths, evenly picked but for u^`tilt` on the way from the shortest to the
/// longest.
std::vector<double> pick(const std::vector<double>& sorted, std::size_t count, double tilt) {
  std::vector<double> picked(count);
  const auto size = static_cast<double>(sorted.size());
  for (std::size_t i = 0; i < count; ++i)
    picked[i] = sorted[std::min(sorted.size() - 1,
                                static_cast<std::size_t>(size * std::pow(stratum(i, count), tilt)))];
  return picked;
}

/// Picks lengths whose mean comes nearest to the one that is wanted; untilted where that is as near.
std::vector<double> pick_nearest(const std::vector<double>& sorted, std::size_t count, double wanted) {
  const auto miss = [&](double tilt) { return wanted - mean(pick(sorted, count, tilt)); };
  const double crossing = bisect(miss, 0.5, 2);
  double best = 1;
  constexpr double aside = 1e-9;  // the mean is a staircase: either side of its step
  for (const double tilt : {crossing * (1 - aside), crossing * (1 + aside)})
    if (std::abs(miss(tilt)) < std::abs(miss(best))) best = tilt;
  return pick(sorted, count, best);
}

// Every length as often as the others; what is left over is picked among all.
std::vector<double> sample(const ListedLengths& list, const Draft& draft) {
  std::vector<double> sorted(list.lengths), lengths;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t rounds = draft.count / sorted.size(), rest = draft.count % sorted.size();
  for (std::size_t round = 0; round < rounds; ++round)
    lengths.insert(lengths.end(), sorted.begin(), sorted.end());
  if (rest == 0) return lengths;
  const double left =
      static_cast<double>(draft.count) * draft.mean - static_cast<double>(lengths.size()) * mean(sorted);
  const std::vector<double> picked = pick_nearest(sorted, rest, left / static_cast<double>(rest));
  lengths.insert(lengths.end(), picked.begin(), picked.end());
  return lengths;
}

/// Scales lengths to a mean, those that would be too short being as long as they may be.
void scale_to_mean(std::vector<double>& lengths, double wanted, double shortest) {
  const auto count = static_cast<double>(lengths.size());
  double scale = wanted / mean(lengths);
  for (double floored = 0, before = -1; floored > before;) {
    before = floored;
    floored = 0;
    double rest = 0;
    for (const double length : lengths) {
      if (scale * length < shortest)
        floored += 1;
      else
        rest += length;
    }
    if (floored == 0) break;
    scale = (wanted * count - shortest * floored) / rest;
  }
  for (double& length : lengths) length = std::max(shortest, scale * length);
}

/// Takes q^α times the scale that gives mean L_N, with α such that the realised L_W is right. Weibull and
/// log-normal families are closed under powers, so the result is still a sample of the family.
/// What would be too short is as long as it may be.
std::vector<double> fit_power(const std::vector<double>& quantiles, const Draft& draft, double weight) {
  const auto powered = [&](double exponent) {
    std::vector<double> lengths(quantiles);
    for (double& length : lengths) length = std::pow(length, exponent);
    scale_to_mean(lengths, draft.mean, draft.shortest);
    return lengths;
  };
  constexpr double widest = 60;
  return powered(bisect([&](double exponent) { return weight_mean(powered(exponent)) - weight; }, 0, widest));
}

/// Quantiles of one uniform draw in each of as many equal strata as there are lengths.
template <class Quantile>
std::vector<double> stratified(const Draft& draft, const Quantile& quantile) {
  std::vector<double> values(draft.count);
  for (std::size_t i = 0; i < draft.count; ++i)
    values[i] = quantile((static_cast<double>(i) + draw(draft.seed, i, place_draw)) /
                         static_cast<double>(draft.count));
  return values;
}

std::vector<double> sample(const WeibullLengths& law, const Draft& draft) {
  const auto quantiles = stratified(draft, [](double u) { return -std::log1p(-u); });
  return fit_power(quantiles, draft, law.weight_average);
}

/// Quantile of the standard normal distribution, by bisection of erfc: fast enough for what is done once.
double normal_quantile(double probability) {
  return bisect([&](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)) - probability; }, -10, 10);
}

std::vector<double> sample(const LogNormalLengths& law, const Draft& draft) {
  const auto quantiles = stratified(draft, [](double u) { return std::exp(normal_quantile(u)); });
  return fit_power(quantiles, draft, law.weight_average);
}

void check(const SingleLength& single) {
  require_positive(single.length, "the fiber length");
}

void check(const LengthHistogram& histogram) {
  const auto& edges = histogram.edges;
  if (histogram.heights.empty() || edges.size() != histogram.heights.size() + 1)
    throw InputError(
        fmt::format("a length histogram has {} edges and {} heights", edges.size(), histogram.heights.size()),
        "give one edge more than heights");
  if (!(edges.front() >= 0) || !std::isfinite(edges.back()) || !are_rising(edges))
    throw InputError("the edges of a length histogram do not rise from 0 or above",
                     "sort them and drop doubles");
  double total = 0;
  for (const double height : histogram.heights) {
    if (!(height >= 0) || !std::isfinite(height))
      throw InputError(fmt::format("a length histogram has the height {:.4g}", height),
                       "give heights of 0 or above");
    total += height;
  }
  if (!(total > 0)) throw InputError("all heights of a length histogram are 0", "give at least one above 0");
}

void check(const ListedLengths& list) {
  if (list.lengths.empty()) throw InputError("the list of fiber lengths is empty", "give at least one");
  for (const double length : list.lengths) require_positive(length, "a fiber length");
}

void check(const WeibullLengths& law) {
  require_means(law.number_average, law.weight_average);
}
void check(const LogNormalLengths& law) {
  require_means(law.number_average, law.weight_average);
}

struct Means {
  double number, weight;
};

Means means(const SingleLength& single) {
  return {single.length, single.length};
}
Means means(const ListedLengths& list) {
  return {mean(list.lengths), weight_mean(list.lengths)};
}
Means means(const WeibullLengths& law) {
  return {law.number_average, law.weight_average};
}
Means means(const LogNormalLengths& law) {
  return {law.number_average, law.weight_average};
}
Means means(const LengthHistogram& histogram) {
  const std::vector<double> shares = number_shares(histogram);
  double first = 0, second = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double low = histogram.edges[i], high = histogram.edges[i + 1];
    first += shares[i] * 0.5 * (low + high);
    second += shares[i] * (low * low + low * high + high * high) / 3;
  }
  return {first, second / first};
}

}  // namespace

void require_admissible(const LengthLaw& law) {
  std::visit([](const auto& kind) { check(kind); }, law);
}

double number_average(const LengthLaw& law) {
  return std::visit([](const auto& kind) { return means(kind).number; }, law);
}

double weight_average(const LengthLaw& law) {
  return std::visit([](const auto& kind) { return means(kind).weight; }, law);
}

std::vector<double> sample_lengths(const LengthLaw& law, const LengthRequest& request) {
  require_admissible(law);
  if (request.count == 0) return {};
  if (request.total) require_number("total", *request.total, positive);
  require_number("shortest", request.shortest, not_negative);
  const double expected = number_average(law), fibers = static_cast<double>(request.count);
  const double wanted = request.total ? *request.total / fibers : expected;
  const Draft draft{request.count,
                    std::clamp(wanted, expected * (1 - most_adjustment), expected * (1 + most_adjustment)),
                    request.shortest, request.seed};
  std::vector<double> lengths = std::visit([&](const auto& kind) { return sample(kind, draft); }, law);
  deal(lengths, request.seed);
  return lengths;
}

int rods_for(double length, double target_rod_length) {
  require_number("length", length, positive);
  if (!(target_rod_length > 0)) return 1;
  const double rods = std::round(length / target_rod_length);
  require_number("length / target_rod_length", rods, {.lower = 0, .upper = most_rods});
  return std::max(1, static_cast<int>(rods));
}

}  // namespace fiberfate
