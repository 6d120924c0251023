// Groups runs into replicas, and merges their numbers and curves.
#pragma once

#include <string>
#include <vector>

#include "results/report_comparison.hpp"

namespace fiberfate {

/// Runs whose cases differ only in their seed and in keys that change no result.
struct Replicas {
  std::string label;
  std::vector<const ComparedRun*> runs;
};

/// Groups runs in the order in which they are given.
[[nodiscard]] std::vector<Replicas> group_replicas(const std::vector<ComparedRun>& runs);

/// Gives histograms whose bins go on in those of another run as many bins as that has, empty ones.
void share_bins(std::vector<ComparedRun>& runs);

/// Gives the mean of some curves at the points of the first one, with a band from the least to the largest; a
/// single curve as it is. Where a curve does not reach, it does not count.
[[nodiscard]] ReportSeries merge_replicas(const std::vector<ReportSeries>& curves);

/// Tells whether two curves have the same points.
[[nodiscard]] bool are_same(const ReportSeries& one, const ReportSeries& other);

}  // namespace fiberfate
