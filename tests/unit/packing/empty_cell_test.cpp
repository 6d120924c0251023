// Tests that grids stay small where a few rods stand in a large cell.
#include <gtest/gtest.h>

#include "packing/box_grid.hpp"
#include "packing/rod_neighbours.hpp"
#include "packing/vacancies.hpp"
#include "unit/packing/random_chains.hpp"

namespace fiberfate {
namespace {

// A cell of 0.2 m with fibers of 20 um: as many boxes as rods would fill take terabytes.
const Cell large_cell = rectangular_cell(Vec3::Constant(1e4));

TEST(BoxGrid, HasNoMoreBoxesThanRodsNeed) {
  const Chains chains = random_chains(large_cell, 1, 10, 5);
  const BoxGrid grid(chains, {1, 0, 1});
  EXPECT_LE(grid.count().prod(), 64 * 10);
  EXPECT_GE(grid.count().minCoeff(), 1);
}

TEST(BoxGrid, HasOneBoxInAFlatCellWhereItIsLow) {
  const Chains chains = random_chains(rectangular_cell({1e5, 1e5, 20}), 2, 10, 5);
  const BoxGrid grid(chains, {1, 0, 1});
  EXPECT_LE(grid.count().prod(), 64 * 20);
  EXPECT_GE(grid.count()[0], 10);
}

TEST(RodNeighbours, AreFoundInALargeCell) {
  Chains chains;
  chains.cell = large_cell;
  for (const double y : {0.5, 9999.8}) {  // neighbours across the cell's face
    for (int k = 0; k < 3; ++k) chains.position.emplace_back(5000 + 5 * k, y, 77);
    end_fiber(chains, 5, 0.5, 0.05);
  }
  RodNeighbours neighbours;
  neighbours.build(chains, {1, 0, 0.1});
  const auto near = neighbours.of(RodIndex(0));
  ASSERT_FALSE(near.empty());
  EXPECT_EQ(near[0].fiber, FiberIndex(1));
}

// Boxes of 250 diameters end between the fiber and a line beside it, for some of these places: both used to
// lie in boxes of their own, the line's one vacant.
TEST(Vacancies, AreNotBesideAFiberWhereverBoxesEnd) {
  for (double y = 5000; y < 5400; y += 0.45) {
    Chains chains;
    chains.cell = large_cell;
    for (int k = 0; k < 3; ++k) chains.position.emplace_back(5000 + 5 * k, y, 77);
    end_fiber(chains, 5, 0.5, 0.05);
    Vacancies vacancies(chains);
    vacancies.fill(chains, FiberIndex(0));
    EXPECT_EQ(vacancies.filled_share({Vec3(5005, y + 0.9, 77), Vec3::UnitX(), 10}), 1) << y;
  }
}

TEST(Vacancies, AreFoundInALargeCell) {
  Chains chains;
  chains.cell = large_cell;
  for (int k = 0; k < 3; ++k) chains.position.emplace_back(5000 + 5 * k, 5100, 77);
  end_fiber(chains, 5, 0.5, 0.05);
  Vacancies vacancies(chains);
  vacancies.fill(chains, FiberIndex(0));
  EXPECT_EQ(vacancies.filled_share({Vec3(5005, 5100, 77), Vec3::UnitX(), 10}), 1);
  EXPECT_EQ(vacancies.filled_share({Vec3(5005, 2000, 77), Vec3::UnitX(), 10}), 0);
}

}  // namespace
}  // namespace fiberfate
