// Blocks a series.
#include "calibration/block_average.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace fiberfate {
namespace {

constexpr std::size_t least_values = 16;
constexpr std::size_t least_blocks = 8;

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Variance of the mean of independent values.
double variance_of_mean(std::span<const double> values) {
  const double mean = mean_of(values), count = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / (count * (count - 1));
}

std::vector<double> paired(const std::vector<double>& values) {
  std::vector<double> blocks(values.size() / 2);
  for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i] = 0.5 * (values[2 * i] + values[2 * i + 1]);
  return blocks;
}

/// The error at every size of block, and how uncertain each is.
struct Level {
  double error, uncertainty;
};

std::vector<Level> levels_of(std::vector<double> blocks) {
  std::vector<Level> levels;
  for (; blocks.size() >= least_blocks; blocks = paired(blocks)) {
    const double error = std::sqrt(variance_of_mean(blocks));
    levels.push_back({error, error / std::sqrt(2.0 * static_cast<double>(blocks.size() - 1))});
  }
  return levels;
}

/// The first error that no later one exceeds by more than its uncertainty; else the largest.
double plateau(const std::vector<Level>& levels) {
  for (auto level = levels.begin(); level != levels.end(); ++level) {
    const auto exceeds = [&](const Level& later) { return later.error - later.uncertainty > level->error; };
    if (std::none_of(level + 1, levels.end(), exceeds)) return level->error;
  }
  return levels.back().error;
}

}  // namespace

BlockMean block_mean(std::span<const double> values) {
  BlockMean result;
  result.values = values.size();
  if (values.empty()) return result;
  result.mean = mean_of(values);
  result.error = result.autocorrelation = std::numeric_limits<double>::quiet_NaN();
  if (values.size() < least_values) return result;
  const std::vector<Level> levels = levels_of({values.begin(), values.end()});
  result.error = plateau(levels);
  const double alone = levels.front().error;
  result.autocorrelation = alone > 0 ? 0.5 * std::pow(result.error / alone, 2) : 0.5;
  return result;
}

}  // namespace fiberfate
