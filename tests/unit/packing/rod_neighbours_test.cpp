// Tests neighbour lists against all pairs of all images, and the repulsion of listed rods against its energy.
#include "packing/rod_neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "fibers/closest_points.hpp"
#include "unit/packing/random_chains.hpp"

namespace fiberfate {
namespace {

struct Pair {
  std::size_t node, other;
  double distance;
};

bool excluded(const Chains& chains, std::size_t fiber, std::size_t node, std::size_t other, double contact) {
  const bool same =
      node >= chains.begin_node(fiber) && other >= chains.begin_node(fiber) && other < chains.end_node(fiber);
  const double between = std::abs(static_cast<double>(node) - static_cast<double>(other)) - 1;
  return same && between * chains.rod_length[fiber] < 2 * contact;
}

/// All pairs of rods within range, over all images up to `most` cells away: the specification of the lists.
std::vector<Pair> brute_force(const Chains& chains, const NeighbourRange& range, int most) {
  std::vector<Pair> pairs;
  std::vector<std::pair<std::size_t, std::size_t>> rods;
  for (std::size_t f = 0; f < chains.rod_length.size(); ++f)
    for (std::size_t k = chains.begin_node(f); k + 1 < chains.end_node(f); ++k) rods.emplace_back(f, k);
  IntVec3 image;
  for (image[0] = -most; image[0] <= most; ++image[0])
    for (image[1] = -most; image[1] <= most; ++image[1])
      for (image[2] = -most; image[2] <= most; ++image[2])
        for (const auto& [f, k] : rods)
          for (const auto& [g, m] : rods) {
            bool possible = true;
            for (int i = 0; i < 3; ++i)
              possible = possible && (image[i] == 0 || chains.cell.boundary[static_cast<std::size_t>(i)] ==
                                                           Boundary::periodic);
            const double contact = range.swelling * (chains.radius[f] + chains.radius[g]) + range.reach;
            if (!possible || (image.isZero() && excluded(chains, f, k, m, contact))) continue;
            const Vec3 shift = chains.cell.shift(image);
            const double farthest =
                0.5 * (chains.rod_length[f] + chains.rod_length[g]) + contact + range.skin;
            const Vec3 apart = 0.5 * (chains.position[k] + chains.position[k + 1] - chains.position[m] -
                                      chains.position[m + 1]) -
                               shift;
            if (apart.squaredNorm() > farthest * farthest) continue;
            const double distance =
                closest_points({chains.position[k], chains.position[k + 1]},
                               {chains.position[m] + shift, chains.position[m + 1] + shift})
                    .distance;
            if (distance < contact + range.skin) pairs.push_back({k, m, distance});
          }
  return pairs;
}

std::vector<Pair> listed(const Chains& chains, const RodNeighbours& neighbours) {
  std::vector<Pair> pairs;
  for (std::size_t f = 0; f < chains.rod_length.size(); ++f)
    for (std::size_t k = chains.begin_node(f); k + 1 < chains.end_node(f); ++k)
      for (const NeighbourRod& other : neighbours.of(k)) {
        const std::size_t m = other.node;
        const double distance =
            closest_points({chains.position[k], chains.position[k + 1]},
                           {chains.position[m] + other.shift, chains.position[m + 1] + other.shift})
                .distance;
        pairs.push_back({k, m, distance});
      }
  return pairs;
}

void expect_same(std::vector<Pair> found, std::vector<Pair> expected) {
  const auto order = [](const Pair& a, const Pair& b) {
    return std::tie(a.node, a.other, a.distance) < std::tie(b.node, b.other, b.distance);
  };
  std::sort(found.begin(), found.end(), order);
  std::sort(expected.begin(), expected.end(), order);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].node, expected[i].node);
    EXPECT_EQ(found[i].other, expected[i].other);
    EXPECT_NEAR(found[i].distance, expected[i].distance, 1e-9);
  }
}

TEST(RodNeighbours, AreAllPairsOfAllImages) {
  Cell tilted = rectangular_cell({12, 15, 18});
  tilted.lattice(0, 1) = 5;
  Cell walled = rectangular_cell({12, 15, 18});
  walled.boundary[1] = Boundary::walls;
  for (const Cell& cell :
       {rectangular_cell({12, 15, 18}), rectangular_cell(Vec3::Constant(7)), tilted, walled}) {
    const Chains chains = random_chains(cell, 12, 6, 4);
    const NeighbourRange range = {1.5, 0.1, 0.4};
    RodNeighbours neighbours;
    neighbours.build(chains, range);
    const auto expected = brute_force(chains, range, 6);
    ASSERT_GT(expected.size(), 20u);
    expect_same(listed(chains, neighbours), expected);
    EXPECT_EQ(neighbours.listed(), static_cast<std::int64_t>(expected.size()));
  }
}

TEST(RodNeighbours, FindImagesOfRodsLongerThanTheCell) {
  const Chains chains = random_chains(rectangular_cell(Vec3::Constant(8)), 6, 1, 21);
  RodNeighbours neighbours;
  neighbours.build(chains, {1, 0, 0.5});
  expect_same(listed(chains, neighbours), brute_force(chains, {1, 0, 0.5}, 8));
}

/// Energy sum of k g² / 2 over all pairs, from the loads (each rod carries half of each of its pairs).
double energy(const Chains& chains, const RepulsionLaw& law, std::vector<RepulsionLoad>& loads,
              RodNeighbours& neighbours) {
  for (std::size_t f = 0; f < chains.rod_length.size(); ++f) neighbours.refresh(chains, f);
  loads.resize(static_cast<std::size_t>(neighbours.rod_count()));
  repulsion_kernel()(neighbours.input(), law, 0, static_cast<int>(neighbours.rod_count()), loads.data());
  double sum = 0;
  for (const RepulsionLoad& load : loads) sum += load.energy;
  return sum;
}

TEST(RodRepulsion, IsMinusTheGradientOfItsEnergy) {
  Chains chains = random_chains(rectangular_cell(Vec3::Constant(14)), 12, 6, 4);
  RodNeighbours neighbours;
  neighbours.build(chains, {1.6, 0, 0.5});
  RepulsionLaw law;
  law.swelling = 1.6;
  law.stiffness = 0.7;
  std::vector<RepulsionLoad> loads, other;
  ASSERT_GT(energy(chains, law, loads, neighbours), 0.1);
  int compared = 0;
  for (std::size_t k = 0; k < chains.position.size(); ++k) {
    Vec3 force = Vec3::Zero();
    const std::size_t fiber = k / 7, place = k % 7;
    if (place < 6)
      force += Vec3(loads[neighbours.slot(k)].on_begin[0], loads[neighbours.slot(k)].on_begin[1],
                    loads[neighbours.slot(k)].on_begin[2]);
    if (place > 0)
      force += Vec3(loads[neighbours.slot(k - 1)].on_end[0], loads[neighbours.slot(k - 1)].on_end[1],
                    loads[neighbours.slot(k - 1)].on_end[2]);
    if (force.norm() < 1e-3) continue;
    ++compared;
    ASSERT_LT(fiber, chains.rod_length.size());
    for (int i = 0; i < 3; ++i) {
      constexpr double step = 1e-6;
      const double before = chains.position[k][i];
      chains.position[k][i] = before + step;
      const double above = energy(chains, law, other, neighbours);
      chains.position[k][i] = before - step;
      const double below = energy(chains, law, other, neighbours);
      chains.position[k][i] = before;
      // Central difference: the second order error is of order step² times curvatures of about 1.
      EXPECT_NEAR(force[i], -(above - below) / (2 * step), 2e-6 * (1 + force.norm()));
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(RodRepulsion, BalancesAndReportsTheLargestOverlap) {
  const Chains chains = random_chains(rectangular_cell(Vec3::Constant(14)), 12, 6, 4);
  RodNeighbours neighbours;
  neighbours.build(chains, {1, 0, 0});
  std::vector<RepulsionLoad> loads;
  (void)energy(chains, RepulsionLaw{}, loads, neighbours);
  Vec3 sum = Vec3::Zero();
  double overlap = -1, expected = -1;
  for (const RepulsionLoad& load : loads) {
    for (int i = 0; i < 3; ++i) sum[i] += load.on_begin[i] + load.on_end[i];
    overlap = std::max(overlap, load.largest_overlap);
  }
  for (const Pair& pair : brute_force(chains, {1, 0, 0}, 3))
    expected = std::max(expected,
                        1 - pair.distance / (chains.radius[pair.node / 7] + chains.radius[pair.other / 7]));
  EXPECT_LT(sum.norm(), 1e-12);
  EXPECT_GT(expected, 0);
  EXPECT_NEAR(overlap, expected, 1e-9);
}

TEST(RodRepulsion, SaturatesAsTheContactLaw) {
  Chains chains = random_chains(rectangular_cell(Vec3::Constant(40)), 0, 1, 4);
  const double gap = 0.8;
  for (const double height : {0.0, gap}) {
    chains.position.push_back({18, 20, 20 + height});
    chains.position.push_back({22, 20, 20 + height});
    end_fiber(chains, 4, 0.5, 0);
  }
  RodNeighbours neighbours;
  neighbours.build(chains, {1, 0.1, 0});
  RepulsionLaw law;
  law.reach = 0.1;
  law.saturation = 0.05;
  law.decay = 4;
  std::vector<RepulsionLoad> loads;
  (void)energy(chains, law, loads, neighbours);
  // Beyond saturation F0 (1 + x + x²/2), x = 4 (1 − 0.8).
  const double x = 4 * (1 - gap);
  EXPECT_NEAR(-(loads[0].on_begin[2] + loads[0].on_end[2]), 0.05 * (1 + x + 0.5 * x * x), 1e-12);
  // Parallel rods touch in the middle of their overlap: no couple.
  EXPECT_NEAR(loads[0].on_begin[2], loads[0].on_end[2], 1e-12);
  // The softer rod limits what a pair bears; the core comes on top.
  chains.firmness[1] = 0.2;
  law.hardness = 2;
  law.core = 0.9;
  neighbours.build(chains, {1, 0.1, 0});
  (void)energy(chains, law, loads, neighbours);
  EXPECT_NEAR(-(loads[0].on_begin[2] + loads[0].on_end[2]), 0.01 * (1 + x + 0.5 * x * x) + 2 * (0.9 - gap),
              1e-12);
}

}  // namespace
}  // namespace fiberfate
