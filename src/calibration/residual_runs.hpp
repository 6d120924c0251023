// Counts runs of residuals on one side, which tell a law that bends in another way than the data from noise.
#pragma once

#include <limits>
#include <span>
#include <vector>

namespace fiberfate {

/// Runs of neighbouring residuals of one sign.
struct ResidualRuns {
  double runs = 0;
  double expected = 0;  ///< of noise
  /// How far the runs are from what is expected, in standard deviations; NaN where there are too few
  /// residuals.
  double deviations = std::numeric_limits<double>::quiet_NaN();
};

/// Counts the runs of several series, each in its order. Of noise every sign is as likely as the other,
/// whatever its neighbour's, so that n residuals have 1 + (n − 1)/2 runs with variance (n − 1)/4. Neglects
/// that a fit takes a little of that freedom. A residual of zero goes with its predecessor.
[[nodiscard]] ResidualRuns count_runs(std::span<const std::vector<double>> residuals);

}  // namespace fiberfate
