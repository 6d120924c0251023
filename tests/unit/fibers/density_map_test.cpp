// Tests maps of the density on populations whose maps are known.
#include "fibers/density_map.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "unit/fibers/sample_fibers.hpp"

namespace fiberfate {
namespace {

double volume_of_straight(const FiberState& state, double length) {
  const double radius = state.materials.front().radius;
  return pi * radius * radius * length / state.cell.volume();
}

TEST(DensityMap, HoldsTheWholeVolume) {
  FiberState state = empty_state();
  state.cell = rectangular_cell({1e-3, 1e-3, 1e-3});
  append_straight(state, Vec3(9e-4, 3e-4, 5e-4), Vec3(3e-5, 4e-5, 1e-5), 9);
  for (const int along : {0, 1, 2}) {
    const DensityMap map = density_map(state, along, 8);
    const double mean = std::reduce(map.volume_fraction.begin(), map.volume_fraction.end()) / 64;
    EXPECT_NEAR(mean, volume_of_straight(state, 9 * Vec3(3e-5, 4e-5, 1e-5).norm()), 1e-15);
  }
}

TEST(DensityMap, PutsAFiberIntoItsColumn) {
  FiberState state = empty_state();
  state.cell = rectangular_cell({1e-3, 1e-3, 1e-3});
  append_straight(state, Vec3(1.1e-3, 6e-4, 2e-4), Vec3(0, 0, 1e-4), 3);  // x wraps to 1e-4
  const DensityMap map = density_map(state, 2, 4);
  EXPECT_EQ(map.across, 0);
  EXPECT_EQ(map.up, 1);
  EXPECT_NEAR(map.volume_fraction[2 * 4 + 0], 16 * volume_of_straight(state, 3e-4), 1e-14);
  EXPECT_EQ(map.volume_fraction[0], 0);
}

TEST(DensityMap, RefusesWhatIsNotThere) {
  EXPECT_THROW((void)density_map(empty_state(), 3, 4), InputError);
  EXPECT_THROW((void)density_map(empty_state(), 0, 0), InputError);
}

}  // namespace
}  // namespace fiberfate
