// Tests that sampled lengths have the mean lengths and the histogram that were asked for.
#include "microstructure/length_distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"

namespace fiberfate {
namespace {

double number_mean(const std::vector<double>& lengths) {
  return std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(lengths.size());
}

double weight_mean(const std::vector<double>& lengths) {
  double squares = 0;
  for (const double length : lengths) squares += length * length;
  return squares / static_cast<double>(lengths.size()) / number_mean(lengths);
}

std::string refusal(const LengthLaw& law) {
  try {
    require_admissible(law);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "accepted";
}

TEST(LengthDistribution, FittedLawsHaveTheirMeans) {
  const double number = 1.1e-3, weight = 2.3e-3;
  for (const LengthLaw& law :
       {LengthLaw(WeibullLengths{number, weight}), LengthLaw(LogNormalLengths{number, weight})}) {
    for (const std::size_t count : {20u, 1000u, 20000u}) {
      const auto lengths = sample_lengths(law, {count, 4});
      ASSERT_EQ(lengths.size(), count);
      EXPECT_NEAR(number_mean(lengths) / number, 1, 1e-9);
      EXPECT_NEAR(weight_mean(lengths) / weight, 1, 1e-9);
      EXPECT_GT(*std::min_element(lengths.begin(), lengths.end()), 0);
    }
  }
}

// The median of a log-normal law is L_N sqrt(L_N / L_W); that of a Weibull law λ (ln 2)^(1/k), here
// exponential (k = 1, where L_W = 2 L_N): L_N ln 2.
TEST(LengthDistribution, FittedLawsHaveTheirMedians) {
  auto lengths = sample_lengths(LogNormalLengths{1e-3, 2e-3}, {20001, 1});
  std::nth_element(lengths.begin(), lengths.begin() + 10000, lengths.end());
  EXPECT_NEAR(lengths[10000] / 1e-3, std::sqrt(0.5), 0.005);
  lengths = sample_lengths(WeibullLengths{1e-3, 2e-3}, {20001, 1});
  std::nth_element(lengths.begin(), lengths.begin() + 10000, lengths.end());
  EXPECT_NEAR(lengths[10000] / 1e-3, std::log(2.0), 0.005);
}

TEST(LengthDistribution, FillsAHistogramToOneFiberABin) {
  const LengthHistogram histogram = {{0, 1e-3, 2e-3, 4e-3, 8e-3}, {1, 5, 3, 0.4}, HistogramHeight::fibers};
  const std::size_t count = 997;
  const auto lengths = sample_lengths(histogram, {count, 2});
  double chi_square = 0;
  for (std::size_t i = 0; i + 1 < histogram.edges.size(); ++i) {
    const auto inside = std::count_if(lengths.begin(), lengths.end(), [&](double length) {
      return length >= histogram.edges[i] && length < histogram.edges[i + 1];
    });
    const double expected = static_cast<double>(count) * histogram.heights[i] / 9.4;
    EXPECT_NEAR(static_cast<double>(inside), expected, 1.0);
    chi_square += std::pow(static_cast<double>(inside) - expected, 2) / expected;
  }
  EXPECT_LT(chi_square, 0.1);  // four bins, each within one fiber; random draws would give about 3
  EXPECT_NEAR(number_mean(lengths) / number_average(histogram), 1, 0.005);
  EXPECT_NEAR(weight_mean(lengths) / weight_average(histogram), 1, 0.005);
}

// Thesis 3.31: fibers of a length = total length × probability / length.
TEST(LengthDistribution, HistogramOfLengthGivesEachBinItsShareOfTheLength) {
  const LengthHistogram histogram = {
      {0.9e-3, 1.1e-3, 1.9e-3, 2.1e-3}, {0.5, 0.0, 0.5}, HistogramHeight::length};
  const auto lengths = sample_lengths(histogram, {3000, 2});
  double in_short = 0, total = 0;
  for (const double length : lengths) {
    total += length;
    if (length < 1.5e-3) in_short += length;
  }
  EXPECT_NEAR(in_short / total, 0.5, 1e-3);
}

TEST(LengthDistribution, DealsSingleAndListedLengths) {
  EXPECT_EQ(sample_lengths(SingleLength{2.5e-3}, {3, 1}), std::vector<double>(3, 2.5e-3));
  auto lengths = sample_lengths(ListedLengths{{1e-3, 2e-3}}, {4, 1});
  std::sort(lengths.begin(), lengths.end());
  EXPECT_EQ(lengths, (std::vector<double>{1e-3, 1e-3, 2e-3, 2e-3}));
  EXPECT_TRUE(sample_lengths(SingleLength{1}, {0, 1}).empty());
}

// Every law with a continuum of lengths meets a total within 0.5 % of what it expects; bins keep their
// counts.
TEST(LengthDistribution, MeetsATotal) {
  const LengthHistogram histogram = {{0, 1e-3, 2e-3, 4e-3, 8e-3}, {1, 5, 3, 0.4}, HistogramHeight::fibers};
  const auto bins = [&](std::vector<double> lengths) {
    std::sort(lengths.begin(), lengths.end());
    std::vector<std::ptrdiff_t> upto;
    for (const double edge : histogram.edges)
      upto.push_back(std::lower_bound(lengths.begin(), lengths.end(), edge) - lengths.begin());
    return upto;
  };
  for (const std::size_t count : {100u, 997u}) {
    for (const LengthLaw& law : {LengthLaw(histogram), LengthLaw(WeibullLengths{1.1e-3, 2.3e-3}),
                                 LengthLaw(LogNormalLengths{1.1e-3, 2.3e-3})}) {
      const double expected = number_average(law), fibers = static_cast<double>(count);
      const auto plain = sample_lengths(law, {count, 2});
      EXPECT_NEAR(number_mean(plain) / expected, 1, 1e-9);
      for (const double ratio : {0.9951, 0.9973, 1.0021, 1.0049}) {
        const auto lengths = sample_lengths(law, {count, 2, ratio * expected * fibers});
        EXPECT_NEAR(number_mean(lengths) / expected, ratio, 1e-9);
        EXPECT_NEAR(weight_mean(lengths) / weight_mean(plain), 1, 0.005);
        if (law.index() == 1) {
          EXPECT_EQ(bins(lengths), bins(plain));
        }
      }
      EXPECT_NEAR(number_mean(sample_lengths(law, {count, 2, 1.2 * expected * fibers})) / expected, 1.0049,
                  1e-9);
    }
  }
}

TEST(LengthDistribution, HasNothingBelowTheShortest) {
  const LengthHistogram histogram = {{0, 1e-3, 2e-3}, {1, 2}, HistogramHeight::fibers};
  for (const LengthLaw& law : {LengthLaw(histogram), LengthLaw(WeibullLengths{0.2e-3, 0.4e-3}),
                               LengthLaw(LogNormalLengths{0.1e-3, 0.4e-3})}) {
    const auto free = sample_lengths(law, {2000, 3}), bounded = sample_lengths(law, {2000, 3, {}, 20e-6});
    EXPECT_LT(*std::min_element(free.begin(), free.end()), 15e-6);
    EXPECT_EQ(*std::min_element(bounded.begin(), bounded.end()), 20e-6);
    EXPECT_NEAR(number_mean(bounded) / number_average(law), 1, 1e-9);
    EXPECT_NEAR(weight_mean(bounded) / weight_average(law), 1, 1e-3);
  }
}

// A list in order of size, as a spreadsheet gives it, of which a cell holds a part.
TEST(LengthDistribution, PicksEvenlyFromAListThatIsLongerThanTheSample) {
  ListedLengths list;
  for (int i = 0; i < 5000; ++i) list.lengths.push_back(1e-3 * std::pow(0.02 + i / 5000.0, 2));
  for (const std::size_t count : {100u, 628u, 7000u}) {
    const auto lengths = sample_lengths(list, {count, 1});
    ASSERT_EQ(lengths.size(), count);
    EXPECT_NEAR(number_mean(lengths) / number_average(list), 1, 0.005);
    EXPECT_NEAR(weight_mean(lengths) / weight_average(list), 1, 0.005);
    for (const double length : lengths)
      EXPECT_TRUE(std::find(list.lengths.begin(), list.lengths.end(), length) != list.lengths.end());
    const double total = 1.003 * static_cast<double>(count) * number_average(list);
    EXPECT_NEAR(number_mean(sample_lengths(list, {count, 1, total})) * static_cast<double>(count), total,
                1e-6);
  }
}

TEST(LengthDistribution, CutsIntoEqualRodsNearTheTarget) {
  EXPECT_EQ(rods_for(2.5e-3, 1e-4), 25);
  EXPECT_EQ(rods_for(2.44e-3, 1e-4), 24);
  EXPECT_EQ(rods_for(1e-5, 1e-4), 1);
  EXPECT_EQ(rods_for(1e-3, 0), 1);
}

TEST(LengthDistribution, RefusesWhatDoesNotExist) {
  EXPECT_EQ(refusal(SingleLength{0}), "the fiber length is 0 m: give a length above zero");
  EXPECT_EQ(refusal(WeibullLengths{2e-3, 1e-3}),
            "the weight average length 0.001 m is below the number average 0.002 m: "
            "L_W is never below L_N; exchange them, or give a single length");
  EXPECT_EQ(refusal(LogNormalLengths{1e-3, 1}), "L_W / L_N is 1000: give at most 20");
  EXPECT_EQ(refusal(LengthHistogram{{0, 1}, {1, 2}, HistogramHeight::fibers}),
            "a length histogram has 2 edges and 2 heights: give one edge more than heights");
  EXPECT_EQ(refusal(LengthHistogram{{0, 2, 1}, {1, 2}, HistogramHeight::fibers}),
            "the edges of a length histogram do not rise from 0 or above: sort them and drop doubles");
  EXPECT_EQ(refusal(LengthHistogram{{0, 1}, {0}, HistogramHeight::fibers}),
            "all heights of a length histogram are 0: give at least one above 0");
  EXPECT_EQ(refusal(ListedLengths{}), "the list of fiber lengths is empty: give at least one");
}

}  // namespace
}  // namespace fiberfate
