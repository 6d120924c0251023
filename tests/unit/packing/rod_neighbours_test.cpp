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
  RodIndex rod, other;
  double distance;
};

/// A rod and its fiber.
struct Rod {
  FiberIndex fiber;
  RodIndex rod;
};

std::vector<Rod> rods_of(const Chains& chains) {
  std::vector<Rod> rods;
  for (const FiberIndex f : chains.fibers())
    for (const RodIndex rod : chains.rods(f)) rods.push_back({f, rod});
  return rods;
}

bool excluded(const Chains& chains, const Rod& one, const Rod& other, double contact) {
  const double between = (std::abs(one.rod - other.rod) - 1) * chains.rod_length[one.fiber];
  return one.fiber == other.fiber && between < 2 * contact;
}

/// All pairs of rods within range, over all images up to `most` cells away: the specification of the lists.
std::vector<Pair> brute_force(const Chains& chains, const NeighbourRange& range, int most) {
  std::vector<Pair> pairs;
  const std::vector<Rod> rods = rods_of(chains);
  IntVec3 image;
  for (image[0] = -most; image[0] <= most; ++image[0])
    for (image[1] = -most; image[1] <= most; ++image[1])
      for (image[2] = -most; image[2] <= most; ++image[2])
        for (const Rod& one : rods)
          for (const Rod& other : rods) {
            const FiberIndex f = one.fiber, g = other.fiber;
            bool possible = true;
            for (int i = 0; i < 3; ++i)
              possible = possible && (image[i] == 0 || chains.cell.boundary[i] == Boundary::periodic);
            const double contact = range.swelling * (chains.radius[f] + chains.radius[g]) + range.reach;
            if (!possible || (image.isZero() && excluded(chains, one, other, contact))) continue;
            const Vec3 shift = chains.cell.shift(image);
            const double farthest =
                0.5 * (chains.rod_length[f] + chains.rod_length[g]) + contact + range.skin;
            const Vec3 apart = chains.centre(one.rod) - chains.centre(other.rod) - shift;
            if (apart.squaredNorm() > farthest * farthest) continue;
            const Segment image_of_other = shifted(chains.segment(other.rod), shift);
            const double distance = closest_points(chains.segment(one.rod), image_of_other).distance;
            if (distance < contact + range.skin) pairs.push_back({one.rod, other.rod, distance});
          }
  return pairs;
}

std::vector<Pair> listed(const Chains& chains, const RodNeighbours& neighbours) {
  std::vector<Pair> pairs;
  for (const Rod& one : rods_of(chains))
    for (const NeighbourRod& other : neighbours.of(one.rod)) {
      const Segment near = shifted(chains.segment(other.rod), other.shift);
      pairs.push_back({one.rod, other.rod, closest_points(chains.segment(one.rod), near).distance});
    }
  return pairs;
}

void expect_same(std::vector<Pair> found, std::vector<Pair> expected) {
  const auto order = [](const Pair& a, const Pair& b) {
    return std::tie(a.rod, a.other, a.distance) < std::tie(b.rod, b.other, b.distance);
  };
  std::sort(found.begin(), found.end(), order);
  std::sort(expected.begin(), expected.end(), order);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].rod, expected[i].rod);
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

using Loads = IndexedVector<SlotIndex, RepulsionLoad>;

/// Energy sum of k g² / 2 over all pairs, from the loads (each rod carries half of each of its pairs).
double energy(const Chains& chains, const RepulsionLaw& law, Loads& loads, RodNeighbours& neighbours) {
  for (const FiberIndex f : chains.fibers()) neighbours.refresh(chains, f);
  loads.resize(neighbours.rod_count());
  repulsion_kernel()(neighbours.input(), law, 0, neighbours.rod_count(), loads.data());
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
  Loads loads, other;
  ASSERT_GT(energy(chains, law, loads, neighbours), 0.1);
  int compared = 0;
  for (const NodeIndex k : chains.nodes()) {
    Vec3 force = Vec3::Zero();
    const FiberIndex fiber(k.value() / 7);
    if (k != chains.last_node(fiber)) force += Vec3(loads[neighbours.slot(rod_after(k))].on_begin);
    if (k != chains.begin_node(fiber)) force += Vec3(loads[neighbours.slot(rod_before(k))].on_end);
    if (force.norm() < 1e-3) continue;
    ++compared;
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
  const auto fiber_of = [](RodIndex rod) { return FiberIndex(rod.value() / 7); };
  const Chains chains = random_chains(rectangular_cell(Vec3::Constant(14)), 12, 6, 4);
  RodNeighbours neighbours;
  neighbours.build(chains, {1, 0, 0});
  Loads loads;
  (void)energy(chains, RepulsionLaw{}, loads, neighbours);
  Vec3 sum = Vec3::Zero();
  double overlap = -1, expected = -1;
  for (const RepulsionLoad& load : loads) {
    for (int i = 0; i < 3; ++i) sum[i] += load.on_begin[i] + load.on_end[i];
    overlap = std::max(overlap, load.largest_overlap);
  }
  for (const Pair& pair : brute_force(chains, {1, 0, 0}, 3))
    expected = std::max(expected, 1 - pair.distance / (chains.radius[fiber_of(pair.rod)] +
                                                       chains.radius[fiber_of(pair.other)]));
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
  Loads loads;
  (void)energy(chains, law, loads, neighbours);
  // Beyond saturation F0 (1 + x + x²/2), x = 4 (1 − 0.8).
  const double x = 4 * (1 - gap);
  EXPECT_NEAR(-(loads[SlotIndex(0)].on_begin[2] + loads[SlotIndex(0)].on_end[2]),
              0.05 * (1 + x + 0.5 * x * x), 1e-12);
  // Parallel rods touch in the middle of their overlap: no couple.
  EXPECT_NEAR(loads[SlotIndex(0)].on_begin[2], loads[SlotIndex(0)].on_end[2], 1e-12);
  // The softer rod limits what a pair bears; the core comes on top.
  chains.firmness[FiberIndex(1)] = 0.2;
  law.hardness = 2;
  law.core = 0.9;
  neighbours.build(chains, {1, 0.1, 0});
  (void)energy(chains, law, loads, neighbours);
  EXPECT_NEAR(-(loads[SlotIndex(0)].on_begin[2] + loads[SlotIndex(0)].on_end[2]),
              0.01 * (1 + x + 0.5 * x * x) + 2 * (0.9 - gap), 1e-12);
}

}  // namespace
}  // namespace fiberfate
