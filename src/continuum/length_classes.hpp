// A population of fibers as classes of equal length, its averages and its histogram.
#pragma once

#include <span>
#include <vector>

#include "microstructure/mean_lengths.hpp"

namespace fiberfate {

/// How many fibers have which length; arrays of equal size, in any order, numbers not negative.
struct LengthClasses {
  std::vector<double> lengths;  ///< m, positive
  std::vector<double> numbers;  ///< fibers, or anything proportional to them
  /// Width of a bin for which each class stands, m: its fibers are spread evenly about its length, but not
  /// beyond the longest one; 0 where they have exactly that length. Only histograms look at it.
  double width = 0;

  /// Raises InputError when sizes differ, nothing is there, or a value is not positive and finite (numbers
  /// may be 0).
  void check() const;
};

/// Averages a population (thesis 2.5, 2.6). Raises InputError for spans of unequal size, for a length or
/// number that is negative or not finite, and for no fibers.
[[nodiscard]] MeanLengths mean_lengths(std::span<const double> lengths, std::span<const double> numbers);
[[nodiscard]] inline MeanLengths mean_lengths(const LengthClasses& classes) {
  return mean_lengths(classes.lengths, classes.numbers);
}

/// The fiber length of a population, sum n L, which no breakage changes.
[[nodiscard]] double total_length(const LengthClasses& classes);

/// Counts the fibers between each two consecutive edges (m, increasing); a fiber at an edge counts above it,
/// at the last edge below it, and classes with a width in parts on either side. The result has edges.size() -
/// 1 numbers; fibers outside the edges are not counted. Raises InputError for edges that do not rise.
[[nodiscard]] std::vector<double> histogram(const LengthClasses& classes, std::span<const double> edges);

}  // namespace fiberfate
