// Computes mean lengths, histograms and their confidence intervals from lists of measured fibers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "microstructure/bootstrap.hpp"

namespace fiberfate {

/// Measured lengths and how many fibers each stands for (empty: one each).
struct MeasuredLengths {
  std::vector<double> lengths;  ///< m, positive
  std::vector<double> numbers = {};
};
[[nodiscard]] inline double number_of(const MeasuredLengths& fibers, std::size_t i) {
  return fibers.numbers.empty() ? 1 : fibers.numbers[i];
}

/// Weighs fibers that were found in a circular sample of diameter d taken out of a flat one, so that they
/// stand for the population: the longer a fiber, the more likely it reaches into the sample. A segment of
/// length l at random meets a convex region of area F and perimeter U in proportion to F + U l/pi (Crofton),
/// so the circle catches 1 + 4 l/(pi d) times what its area would, and N = N_measured / (1 + 4 l/(pi d)).
/// Presumes straight fibers, random in the plane, kept whole when the sample is taken. Raises InputError
/// unless d > 0. Source: Kunc, Frame, Nguyen, Tucker, Velez-Garcia, SPE ACCE (2007); thesis 4.3.
[[nodiscard]] MeasuredLengths corrected_for_sampling(const MeasuredLengths& measured, double sample_diameter);

/// Number average L_N = sum N L / sum N (2.5), m. Raises InputError for an empty list or an impossible length
/// or number.
[[nodiscard]] double number_average(const MeasuredLengths& fibers);
/// Weight average L_W = sum N L² / sum N L (2.6), m; raises as number_average.
[[nodiscard]] double weight_average(const MeasuredLengths& fibers);

/// Counts fibers by length; bin k holds edges[k] <= L < edges[k+1], the last one its upper edge too.
/// `by_number` and `by_length` are shares that sum to 1 over the fibers inside the edges. Raises InputError
/// unless edges rise.
struct LengthShares {
  std::vector<double> edges;      ///< m
  std::vector<double> by_number;  ///< share of the number of fibers
  std::vector<double> by_length;  ///< share of the total length
};
[[nodiscard]] LengthShares length_shares(const MeasuredLengths& fibers, const std::vector<double>& edges);
/// The standard deviation of `by_number` from the list's finite size, to first order: sqrt(sum N_i²
/// (inside_i - share)²)/sum N_i; an empty bin is as uncertain as one typical fiber. Raises as length_shares.
[[nodiscard]] std::vector<double> share_deviations(const MeasuredLengths& fibers, const LengthShares& shares);
/// Makes edges of equal width from 0 to the longest fiber.
[[nodiscard]] std::vector<double> even_edges(const MeasuredLengths& fibers, int bins);

/// The mean lengths with percentile-bootstrap limits.
struct LengthIntervals {
  Interval number_average;  ///< L_N, m
  Interval weight_average;  ///< L_W, m
};

/// Finds intervals from draws of the list's fibers with replacement; a correction for sampling goes along
/// with each fiber. The same seed gives the same intervals. Source: Efron, Ann. Stat. 7, 1 (1979).
[[nodiscard]] LengthIntervals bootstrap_mean_lengths(const MeasuredLengths& fibers,
                                                     const Resampling& resampling);

}  // namespace fiberfate
