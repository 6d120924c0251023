// Tests where fibers find room, and which are moved to it.
#include "packing/relief.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "packing/vacancies.hpp"
#include "unit/packing/random_chains.hpp"

namespace fiberfate {
namespace {

/// Straight chains along x in a cube of 20 diameters, cut in rods of 4; `places` holds y and z.
Chains parallel_chains(const std::vector<std::pair<double, double>>& places) {
  Chains chains;
  chains.cell = rectangular_cell(Vec3::Constant(20));
  for (const auto& [y, z] : places) {
    for (int k = 0; k <= 4; ++k) chains.position.emplace_back(2 + 4 * k, y, z);
    end_fiber(chains, 4, 0.5, 0.05);
  }
  return chains;
}

Vec3 middle(const Chains& chains, int fiber) {
  return chains.position[chains.begin_node(FiberIndex(fiber)) + 2];
}

TEST(Vacancies, AreWhereNoAxisIsNearerThanADiameter) {
  const Chains chains = parallel_chains({{10, 0.5}});
  Vacancies vacancies(chains);
  vacancies.fill(chains, FiberIndex(0));
  const auto filled = [&](double y, double z) {
    return vacancies.filled_share({Vec3(10, y, z), Vec3::UnitX(), 16});
  };
  EXPECT_EQ(filled(10, 0.5), 1);
  EXPECT_EQ(filled(10, 2.5), 0);
  EXPECT_EQ(filled(12, 0.5), 0);
  EXPECT_EQ(filled(10, -0.1), 1);  // in the next image of the cell
  EXPECT_EQ(filled(10, 20.5), 1);
  // Across the fiber two diameters of twenty are filled, to one box.
  EXPECT_NEAR(vacancies.filled_share({Vec3(10, 10, 0.5), Vec3::UnitY(), 20}), 0.1, 0.04);
}

TEST(Vacancies, StopCountingWhereEnoughIsFilled) {
  const Chains chains = parallel_chains({{10, 10}});
  Vacancies vacancies(chains);
  vacancies.fill(chains, FiberIndex(0));
  const StraightAxis along = {Vec3(10, 10, 10), Vec3::UnitX(), 16};
  EXPECT_EQ(vacancies.filled_share(along), 1);
  const double stopped = vacancies.filled_share(along, 0.25);
  EXPECT_GT(stopped, 0.25);
  EXPECT_LT(stopped, 0.4);
}

TEST(Vacancies, EndAtWalls) {
  Chains chains = parallel_chains({{10, 10}});
  chains.cell.boundary[1] = Boundary::walls;
  const Vacancies vacancies(chains);
  EXPECT_EQ(vacancies.filled_share({Vec3(10, 5, 5), Vec3::UnitX(), 16}), 0);
  EXPECT_EQ(vacancies.filled_share({Vec3(10, -1, 5), Vec3::UnitX(), 16}), 1);
  EXPECT_NEAR(vacancies.filled_share({Vec3(10, 0, 5), Vec3::UnitY(), 16}), 0.5, 0.05);
}

TEST(Relief, MovesTheFiberThatIsInTheWayOfTwo) {
  // The second overlaps the first and the third by a fifth; the fourth touches nothing.
  Chains chains = parallel_chains({{5, 5}, {5.8, 5}, {6.6, 5}, {12, 12}});
  const Chains before = chains;
  Minimiser minimiser(chains, Mat3::Identity() / 3);
  minimiser.use({});
  static_cast<void>(minimiser.measure());
  Relief relief(chains, minimiser, 1);
  EXPECT_EQ(relief.find(0.3), 0U);
  EXPECT_EQ(relief.find(0.1), 1U);
  relief.move();
  for (const int f : {0, 2, 3}) EXPECT_EQ(middle(chains, f), middle(before, f));
  EXPECT_NE(middle(chains, 1), middle(before, 1));
  static_cast<void>(minimiser.measure());
  EXPECT_EQ(relief.find(0.1), 0U);
  // It keeps its direction and its length.
  const Vec3 fiber = chains.position[NodeIndex(9)] - chains.position[NodeIndex(5)];
  EXPECT_NEAR((fiber - Vec3(16, 0, 0)).norm(), 0, 1e-12);
}

TEST(Relief, AltersOnlyWhatItMoves) {
  Chains chains = parallel_chains({{5, 5}, {5.8, 5}, {6.6, 5}});
  Minimiser minimiser(chains, Mat3::Identity() / 3);
  minimiser.use({});
  static_cast<void>(minimiser.measure());
  Relief relief(chains, minimiser, 1);
  relief.find(0.1);
  relief.alter({16, 4, 0.2});
  relief.alter({8, 3, 0.5});
  EXPECT_EQ(chains.bending_stiffness, (std::vector<double>{0.05, 0.4, 0.05}));
  EXPECT_EQ(chains.swelling, (std::vector<double>{1, 3, 1}));
  EXPECT_EQ(chains.firmness, (std::vector<double>{1, 0.5, 1}));
}

TEST(Relief, TellsTheMinimiserOfSwollenAndShrunkFibers) {
  Chains chains = parallel_chains({{5, 5}, {5.8, 5}, {7.3, 5}});
  Minimiser minimiser(chains, Mat3::Identity() / 3);
  minimiser.use({});
  static_cast<void>(minimiser.measure());
  const RodIndex first(0), third = chains.rods(FiberIndex(2)).front();
  const double before = minimiser.overlap(third);
  Relief relief(chains, minimiser, 1);
  ASSERT_EQ(relief.find(0.1), 1U);
  for (const double swelling : {3.0, 1.0}) {
    relief.alter({1, swelling, 1});
    static_cast<void>(minimiser.measure());
    // Of both: the fiber that was found is one of the first two.
    const double largest = std::max(minimiser.overlap(third), minimiser.overlap(first));
    EXPECT_NEAR(largest, 1 - 0.8 / (0.5 + 0.5 * swelling), 1e-12);
  }
  EXPECT_EQ(minimiser.overlap(third), before);
}

TEST(Relief, PrefersWhatItHasNotMovedYet) {
  Chains chains = parallel_chains({{5, 5}, {5.8, 5}});
  Minimiser minimiser(chains, Mat3::Identity() / 3);
  minimiser.use({});
  static_cast<void>(minimiser.measure());
  Relief relief(chains, minimiser, 1);
  relief.find(0.1);
  relief.move();
  const Vec3 stays = middle(chains, 1);
  EXPECT_EQ(stays, Vec3(10, 5.8, 5));
  // Back into the way: now the other one is taken.
  for (int k = 0; k <= 4; ++k) chains.position[NodeIndex(k)] = Vec3(2 + 4 * k, 5, 5);
  minimiser.forget_neighbours();
  static_cast<void>(minimiser.measure());
  EXPECT_EQ(relief.find(0.1), 1U);
  relief.move();
  EXPECT_EQ(middle(chains, 0), Vec3(10, 5, 5));
  EXPECT_NE(middle(chains, 1), stays);
}

}  // namespace
}  // namespace fiberfate
