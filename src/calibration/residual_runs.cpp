// Counts runs of residuals.
#include "calibration/residual_runs.hpp"

#include <cmath>

namespace fiberfate {
namespace {

double runs_of(const std::vector<double>& residuals) {
  double runs = 1, sign = 0;
  for (const double residual : residuals) {
    if (residual == 0) continue;
    const double now = residual > 0 ? 1 : -1;
    if (sign != 0 && now != sign) runs += 1;
    sign = now;
  }
  return runs;
}

}  // namespace

ResidualRuns count_runs(std::span<const std::vector<double>> residuals) {
  constexpr double least_neighbours = 6;
  ResidualRuns found;
  double neighbours = 0;
  for (const std::vector<double>& one : residuals) {
    if (one.size() < 2) continue;
    const auto pairs = static_cast<double>(one.size() - 1);
    found.runs += runs_of(one);
    found.expected += 1 + 0.5 * pairs;
    neighbours += pairs;
  }
  if (neighbours >= least_neighbours)
    found.deviations = (found.runs - found.expected) / std::sqrt(0.25 * neighbours);
  return found;
}

}  // namespace fiberfate
