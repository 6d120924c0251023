// Draws fiber lengths from one value, a histogram, a list, or a Weibull or log-normal law with given mean
// lengths.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace fiberfate {

/// All fibers have one length.
struct SingleLength {
  double length = 0;  ///< m
};

/// What the heights of a histogram of lengths count.
enum class HistogramHeight {
  fibers,  ///< share of the number of fibers
  length,  ///< share of the total length (of the segments: thesis 3.30, 3.31)
};

/// Fibers are distributed over bins of length; within a bin evenly from edge to edge.
struct LengthHistogram {
  std::vector<double> edges;    ///< rising, one more than bins, m
  std::vector<double> heights;  ///< at least 0, any scale
  HistogramHeight height = HistogramHeight::fibers;
};

/// Fibers have these lengths, each equally often; fewer fibers than entries have evenly picked ones.
struct ListedLengths {
  std::vector<double> lengths;  ///< m
};

/// Weibull distribution by number: P(L < x) = 1 − exp(−(x/λ)^k), fitted to L_N and L_W.
struct WeibullLengths {
  double number_average = 0;  ///< L_N, m
  double weight_average = 0;  ///< L_W, m
};

/// Log-normal distribution by number, fitted to L_N and L_W: variance of ln L is ln(L_W / L_N).
struct LogNormalLengths {
  double number_average = 0;  ///< L_N, m
  double weight_average = 0;  ///< L_W, m
};

using LengthLaw =
    std::variant<SingleLength, LengthHistogram, ListedLengths, WeibullLengths, LogNormalLengths>;

/// Checks a law: positive lengths, rising edges, L_N < L_W, ... Raises InputError that says what would be
/// possible.
void require_admissible(const LengthLaw& law);

/// Mean length by number L_N of the law, m.
[[nodiscard]] double number_average(const LengthLaw& law);
/// Mean length by weight L_W of the law, m.
[[nodiscard]] double weight_average(const LengthLaw& law);

/// How many lengths are drawn, and what they come to.
struct LengthRequest {
  std::size_t count = 0;
  std::uint64_t seed = 1;
  std::optional<double> total = {};  ///< sum of the lengths, m; not given: count times the mean of the law
  double shortest = 0;               ///< what a histogram or smooth law has below it is as long as this, m
};

/// Draws lengths (m), dealt at random; raises InputError as require_admissible, and for an impossible
/// request. They are stratified: every fiber stands for an equal share of the law. Weibull and log-normal
/// laws of two fibers and more have the law's L_W and the total to round-off; a histogram's bins hold their
/// shares to one fiber, and inside them fibers move until the total is right; a list's lengths are used
/// equally often and the rest is picked such that the total comes nearest; a single length is kept as it is.
/// For the sake of a total L_N is changed by less than 0.5 %.
[[nodiscard]] std::vector<double> sample_lengths(const LengthLaw& law, const LengthRequest& request);

/// Number of equal rods in which a fiber of this length is cut so that they are nearest to the target; at
/// least one.
[[nodiscard]] int rods_for(double length, double target_rod_length);

}  // namespace fiberfate
