// The mean of a stationary series, with an error that counts how long its values remember each other.
#pragma once

#include <cstddef>
#include <span>

namespace fiberfate {

/// The mean of correlated values.
struct BlockMean {
  double mean = 0;
  double error = 0;  ///< standard error of the mean; NaN for fewer than 16 values
  double autocorrelation =
      0;  ///< integrated time of the autocorrelation, in values; 1/2: they are independent
  std::size_t values = 0;
};

/// Averages neighbours into blocks, again and again, until the standard error of the mean of blocks no longer
/// grows beyond its own uncertainty. Source: Flyvbjerg and Petersen, J. Chem. Phys. 91, 461 (1989).
[[nodiscard]] BlockMean block_mean(std::span<const double> values);

}  // namespace fiberfate
