// Compares the lengths of fibers with the law that was asked for (thesis figure 3.8).
#pragma once

#include <cstdint>
#include <vector>

#include "studies/sample/case.hpp"

namespace fiberfate {

/// Counts fibers by length beside what the law expects.
struct LengthComparison {
  std::vector<double> edges;     ///< of the bins, m; those of the histogram where it holds all fibers
  std::vector<double> found;     ///< fibers
  std::vector<double> expected;  ///< fibers
  /// Pearson's sum of (found − expected)²/expected over the bins where at least five fibers are expected, and
  /// one more for all the others together.
  double chi_square = 0;
  int chi_square_bins = 0;
  double number_average = 0;  ///< L_N of the law, m
  double weight_average = 0;  ///< L_W of the law, m
};

/// Compares the lengths of a generated sample's fibers, all kinds together, with the laws of the case.
[[nodiscard]] LengthComparison compare_lengths(const SampleCase& sample, const std::vector<double>& lengths);

/// Sets what was asked of one kind of fibers beside what came out.
struct KindComparison {
  std::int64_t fibers = 0;
  double number_average = 0;  ///< L_N, m
  double number_average_asked = 0;
  double weight_average = 0;  ///< L_W, m
  double weight_average_asked = 0;
  double volume_share = 0;  ///< of the volume of all fibers
  double volume_share_asked = 0;
};

/// Compares the kinds of a generated sample's fibers with what the case says of them, the first one first.
[[nodiscard]] std::vector<KindComparison> compare_kinds(const SampleCase& sample, const FiberState& state);

}  // namespace fiberfate
