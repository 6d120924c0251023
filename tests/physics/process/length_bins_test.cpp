// Bins of the Phelps-Tucker model stand for the lengths around them: histograms do not show where bins and
// edges meet.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "calibration/fit.hpp"
#include "continuum/attrition_law.hpp"
#include "continuum/length_registry.hpp"

namespace fiberfate {
namespace {

constexpr double longest = 12e-3;
constexpr LengthFlow flow = {100, 300, 1};

std::vector<double> edges_of(std::size_t count) {
  std::vector<double> edges;
  for (std::size_t k = 0; k <= count; ++k)
    edges.push_back(longest * static_cast<double>(k) / static_cast<double>(count));
  return edges;
}

/// Shares of the number of fibers in each bin of a histogram, of fibers of 12 mm that have broken for 1.5 s.
std::vector<double> shares(double zeta, std::size_t bins, const std::vector<double>& edges) {
  const auto law = make_attrition_law("phelps", std::vector<double>{0.02, zeta, 0.25, 73e9, 19e-6, 0});
  const auto evolution = law->start({.initial = {{longest}, {1}}, .bins = {bins, longest}});
  evolution->advance(flow, 1.5);
  std::vector<double> counts = histogram(evolution->population(), edges);
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  for (double& count : counts) count /= all;
  return counts;
}

/// 100 bins under 30 edges: three or four bins' lengths fall between two edges, which made every fourth share
/// a third too high. Spread over their widths, bins err as the model's own discretisation does: in second
/// order of the width.
TEST(LengthBins, HistogramsAreSmooth) {
  const std::vector<double> edges = edges_of(30);
  const std::vector<double> coarse = shares(3, 100, edges), fine = shares(3, 1500, edges);
  for (std::size_t k = 2; k + 1 < fine.size(); ++k)  // below, L_ub is resolved by a few bins only
    EXPECT_NEAR(coarse[k], fine[k], 0.03 * fine[k]) << k;
}

TEST(LengthBins, EveryFiberIsCountedOnce) {
  const LengthClasses population = {{1e-3, 2e-3, 3e-3}, {4, 5, 6}, 1e-3};
  const std::vector<double> counts = histogram(population, std::vector<double>{0, 1e-3, 2.25e-3, 3e-3});
  // [0.5, 1.5], [1.5, 2.5] and [2.5, 3.0] mm, the last one's half cell.
  EXPECT_NEAR(counts[0], 2, 1e-12);
  EXPECT_NEAR(counts[1], 2 + 0.75 * 5, 1e-12);
  EXPECT_NEAR(counts[2], 0.25 * 5 + 6, 1e-12);
  // Without a width, fibers have exactly their length.
  EXPECT_EQ(histogram({{1e-3, 2e-3, 3e-3}, {4, 5, 6}}, std::vector<double>{0, 1e-3, 2.25e-3, 3e-3}),
            (std::vector<double>{0, 9, 6}));
}

/// A histogram without noise, made with many bins, gives its own zeta back when it is fitted with 100: the
/// buckling coefficient places the shoulder of the distribution, which point masses moved from edge to edge.
TEST(LengthBins, CalibrationFindsTheDragOfANoiseFreeHistogram) {
  const std::vector<double> edges = edges_of(30);
  FitProblem problem;
  problem.parameters = {
      {.name = "zeta", .initial = 1.5, .lower = 0.3, .upper = 30, .scale = ParameterScale::logarithmic}};
  const std::vector<double> observed = shares(3, 1500, edges);
  problem.series = {{"shares", "1", observed, std::vector<double>(observed.size(), 0.01)}};
  problem.model = [&](std::span<const double> values, std::span<double> predictions) {
    const std::vector<double> predicted = shares(values[0], 100, edges);
    std::copy(predicted.begin(), predicted.end(), predictions.begin());
  };
  const FitResult found = fit(problem);
  EXPECT_TRUE(found.converged);
  // What is left is the model's discretisation, 0.12 mm under L_ub = 1 mm.
  EXPECT_NEAR(found.values[0], 3, 0.1);
}

}  // namespace
}  // namespace fiberfate
