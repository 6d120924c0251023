// Checks that fibers which wander, some of them far, are listed with whatever they may touch.
#include "fibers/neighbour_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/random.hpp"
#include "dynamics/motion.hpp"

namespace fiberfate {
namespace {

constexpr double range = 2.5e-5;
constexpr double step = 1e-4;
using Pair = std::array<int, 5>;  // first rod, second rod, image of the second

Vec3 draw(std::uint32_t fiber, std::uint32_t node, std::uint32_t time) {
  const auto u = uniform4(11, RandomStream::position, {fiber, node, time});
  return Vec3(u[0], u[1], u[2]) - Vec3::Constant(0.5);
}

/// Thirty bent fibers of six rods in a tilted cell, with a wall in one direction if asked.
FiberState crowd(Boundary across) {
  FiberState state;
  state.materials = {{9.5e-6, 73e9, 2550}};
  state.cell.lattice << 3e-4, 1e-4, 0, 0, 3e-4, 0, 0, 0, 3e-4;
  state.cell.boundary[1] = across;
  for (std::uint32_t f = 0; f < 30; ++f) {
    std::vector<Vec3> nodes = {state.cell.lattice * (draw(f, 0, 0) + Vec3::Constant(0.5))};
    Vec3 axis = draw(f, 1, 0);
    for (std::uint32_t k = 2; k < 8; ++k) {
      axis = axis.normalized() + 0.5 * draw(f, k, 0);
      nodes.push_back(nodes.back() + 5e-5 * axis.normalized());
    }
    append_fiber(state, {nodes, 0});
  }
  return state;
}

/// What every node does next relative to the fluid: every fifth fiber is ten times as fast as the others.
IndexedVector<NodeIndex, Vec3> wander(const FiberState& state) {
  IndexedVector<NodeIndex, Vec3> velocity(state.position.size());
  for (const FiberIndex f : state.fibers()) {
    const auto number = static_cast<std::uint32_t>(f.value());
    const Vec3 drift = (number % 5 == 0 ? 0.1 : 0.01) * draw(number, 0, 1);
    for (const NodeIndex node : state.nodes(f))
      velocity[node] = drift + 0.01 * draw(number, static_cast<std::uint32_t>(node.value()),
                                           static_cast<std::uint32_t>(state.step));
  }
  return velocity;
}

/// Every pair of rods nearer than `range`, found one by one.
std::set<Pair> near_pairs(const FiberState& state) {
  std::set<Pair> pairs;
  const Mat3 to_fraction = state.cell.lattice.inverse();
  const auto look_at = [&](RodIndex one, FiberIndex fiber, RodIndex other, FiberIndex other_fiber) {
    const Vec3 apart = to_fraction * (state.centre(one) - state.centre(other));
    const IntVec3 nearest = apart.array().round().cast<int>().matrix();
    for (int i = 0; i < 27; ++i) {
      const IntVec3 image = nearest + IntVec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const Vec3 between = state.cell.lattice * (apart - image.cast<double>());
      if (between.norm() > 5e-5 + range) continue;
      if (state.cell.boundary[1] == Boundary::walls && image[1] != 0) continue;
      if (one == other && !(std::array{image[0], image[1], image[2]} > std::array{0, 0, 0})) continue;
      if (image.isZero() && fiber == other_fiber && other - one < 2) continue;  // they share a node
      const Segment moved = shifted(state.segment(other), state.cell.shift(image));
      if (closest_points(state.segment(one), moved).distance < range)
        pairs.insert({one.value(), other.value(), image[0], image[1], image[2]});
    }
  };
  for (const FiberIndex f : state.fibers()) {
    for (const RodIndex one : state.rods(f)) {
      for (FiberIndex g = f; g < FiberIndex(state.fiber_count()); ++g) {
        for (const RodIndex other : state.rods(g)) {
          if (other >= one) look_at(one, f, other, g);
        }
      }
    }
  }
  return pairs;
}

/// Every pair of the list that is awake, of which there must be none twice.
std::set<Pair> awake_pairs(NeighbourList& list) {
  std::set<Pair> pairs;
  for (const RodPairs& chunk : list.chunks()) {
    for (Index i = 0; i < chunk.size(); ++i) {
      const IntVec3 image = unpack_image(chunk.image[i]);
      const Pair pair = {chunk.first[i].value(), chunk.second[i].value(), image[0], image[1], image[2]};
      if (list.reach()[chunk.first[i]] + list.reach()[chunk.second[i]] < chunk.wake[i]) continue;
      EXPECT_TRUE(pairs.insert(pair).second) << "twice: rods " << pair[0] << " and " << pair[1];
    }
  }
  return pairs;
}

struct Tally {
  int near = 0, built = 0, renewed = 0;
};

/// What is tried on a crowd.
struct Trial {
  Boundary across = Boundary::periodic;
  int steps = 0;
  int steps_between_breaks = 1000000;
};

/// Breaks every third fiber that has three rods or more at its middle.
std::vector<NodeIndex> break_some(FiberState& state) {
  std::vector<NodeIndex> broken;
  for (const FiberIndex f : state.fibers()) {
    if (f.value() % 3 == 0 && state.rod_count(f) > 2)
      broken.push_back(state.begin_node(f) + state.rod_count(f) / 2);
  }
  split_fibers(state, broken);
  return broken;
}

/// Steps the crowd and compares at every step what is near with what is listed and awake.
Tally follow(const Trial& trial) {
  FiberState state = crowd(trial.across);
  const Flow flow = simple_shear(20, 200);
  NeighbourList list;
  Tally tally;
  bool is_stale = true;
  while (state.step < trial.steps) {
    if ((state.step + 1) % trial.steps_between_breaks == 0) {
      const std::vector<NodeIndex> broken = break_some(state);
      if (!is_stale) list.split(state, broken);
    }
    IndexedVector<RodIndex, double> travelled(state.position.size());
    const IndexedVector<RodIndex, double> margin(state.position.size(), 1.2e-5);
    const bool covers = list.look_ahead(state, flow, step) && !is_stale;
    if (!covers && (is_stale || !list.renew(state, margin))) {
      list.build(state, range, margin);
      EXPECT_TRUE(list.look_ahead(state, flow, step));
      ++tally.built;
    } else if (!covers) {
      ++tally.renewed;
    }
    const std::set<Pair> near = near_pairs(state);
    const std::set<Pair> listed = awake_pairs(list);
    EXPECT_TRUE(std::includes(listed.begin(), listed.end(), near.begin(), near.end()))
        << "at step " << state.step;
    tally.near += static_cast<int>(near.size());
    move_fibers(state, flow, step, wander(state), travelled);
    list.carry(flow, step, travelled);
    is_stale = tidy_cell(state);
  }
  return tally;
}

TEST(NeighbourList, MissesNoPairOfFibersThatWander) {
  const Tally tally = follow({Boundary::periodic, 600});
  EXPECT_GT(tally.near, 600 * 10);
  EXPECT_GT(tally.renewed, 100);
  EXPECT_GT(tally.built, 1);
  EXPECT_LT(tally.built, tally.renewed / 4);
}

TEST(NeighbourList, MissesNoPairBetweenWalls) {
  const Tally tally = follow({Boundary::walls, 200});
  EXPECT_GT(tally.near, 200 * 10);
  EXPECT_GT(tally.renewed, 30);
}

TEST(NeighbourList, MissesNoPairOfFibersThatBreak) {
  const Tally tally = follow({Boundary::periodic, 100, 12});
  EXPECT_GT(tally.near, 100 * 10);
  EXPECT_LT(tally.built, 10);
}

}  // namespace
}  // namespace fiberfate
