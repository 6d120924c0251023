// Where the cell is cut out of space, and which image stands for a fiber, changes nothing.
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace fiberfate {
namespace {

constexpr double rate = 100;       // 1/s
constexpr double duration = 1e-2;  // s: a strain of one

// 6 % by volume of fibers longer than the cell.
FiberState crowded_cell() {
  return scenes::scatter({.fibers = 14, .length = 4e-4, .rods = 5, .cell = 3e-4, .seed = 5});
}

FiberState run(const FiberState& start) {
  Simulation simulation(scenes::fixed_step(5e-5), FlowHistory::constant(rate, scenes::melt_viscosity), start);
  std::int64_t contacts = 0;
  while (simulation.state().time < duration) {
    simulation.advance(duration);
    contacts += simulation.contact_statistics().contacts;
  }
  EXPECT_GT(contacts, 100) << "without contacts nothing is tested";
  return simulation.state();
}

/// Largest difference of nodes' positions after taking off the shift that each fiber began with, which the
/// flow has carried since, and whole lattice vectors; in radii.
double largest_difference(const FiberState& a, const FiberState& b,
                          const IndexedVector<FiberIndex, Vec3>& shifts) {
  Mat3 carried = Mat3::Identity();
  carried(0, 1) = rate * duration;
  double largest = 0;
  for (const FiberIndex f : a.fibers()) {
    for (const NodeIndex n : a.nodes(f)) {
      const Vec3 apart = b.position[n] - a.position[n] - carried * shifts[f];
      const Vec3 images = (a.cell.lattice.inverse() * apart).array().round();
      largest = std::max(largest, (apart - a.cell.lattice * images).norm());
    }
  }
  return largest / scenes::glass.radius;
}

// Round-off of positions, 1e-16 of the cell, is amplified by contacts that close and open: a thousandfold in
// 100 steps.
constexpr double tolerance = 1e-9;

TEST(ImageInvariance, ShiftingEverythingByAnyVectorChangesNothing) {
  const FiberState start = crowded_cell();
  const FiberState plain = run(start);
  for (const Vec3& shift : {Vec3(1.3e-4, -0.7e-4, 2.9e-4), Vec3(0, 7.77e-4, 0)}) {
    FiberState shifted = start;
    for (Vec3& x : shifted.position) x += shift;
    const IndexedVector<FiberIndex, Vec3> shifts(start.fiber_count(), shift);
    EXPECT_LT(largest_difference(plain, run(shifted), shifts), tolerance);
  }
}

TEST(ImageInvariance, ChoosingOtherImagesOfFibersChangesNothing) {
  const FiberState start = crowded_cell();
  FiberState other = start;
  IndexedVector<FiberIndex, Vec3> shifts;
  for (const FiberIndex fiber : start.fibers()) {
    const Index f = fiber.value();
    shifts.push_back(start.cell.shift(IntVec3(f % 3 - 1, f % 5 - 2, f % 2)));
    for (const NodeIndex node : start.nodes(fiber)) other.position[node] += shifts.back();
  }
  EXPECT_LT(largest_difference(run(start), run(other), shifts), tolerance);
}

// The lattice of a sheared cell has many bases: after a strain of exactly one the cell is what it was at the
// start.
TEST(ImageInvariance, ChoosingAnotherBasisOfTheLatticeChangesNothing) {
  const FiberState start = crowded_cell();
  FiberState other = start;
  other.cell.lattice.col(1) += other.cell.lattice.col(0);
  const IndexedVector<FiberIndex, Vec3> shifts(start.fiber_count(), Vec3::Zero());
  EXPECT_LT(largest_difference(run(start), run(other), shifts), tolerance);
}

}  // namespace
}  // namespace fiberfate
