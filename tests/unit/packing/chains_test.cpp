// Tests the projection on motions that stretch no rod, and the restoring of rod lengths.
#include "packing/chains.hpp"

#include <gtest/gtest.h>

#include "unit/packing/random_chains.hpp"

namespace fiberfate {
namespace {

TEST(ChainConstraints, ProjectedVectorsStretchNoRod) {
  for (const int rods : {1, 2, 25}) {
    Chains chains = random_chains(rectangular_cell(Vec3::Constant(50)), 1, rods, 5);
    for (const NodeIndex k : chains.nodes()) {
      const auto u = uniform4(8, RandomStream::noise, {static_cast<std::uint32_t>(k.value()), 0, 0});
      chains.force[k] = {u[0] - 0.5, u[1] - 0.5, u[2] - 0.5};
    }
    Vec3 sum = Vec3::Zero();
    for (const Vec3& f : chains.force) sum += f;
    ChainConstraints constraints;
    constraints.factorise(chains.position, 5);
    constraints.project(chains.force.data());
    Vec3 projected = Vec3::Zero();
    for (const Vec3& f : chains.force) projected += f;
    EXPECT_LT((sum - projected).norm(), 1e-13);  // tensions are internal
    for (const RodIndex rod : chains.rods(FiberIndex(0))) {
      const Vec3 stretch = chains.force[second_end(rod)] - chains.force[first_end(rod)];
      EXPECT_NEAR(chains.axis(rod).dot(stretch), 0, 1e-13);
    }
  }
}

TEST(ChainConstraints, RestoresLengthsAndKeepsTheCentre) {
  Chains chains = random_chains(rectangular_cell(Vec3::Constant(50)), 1, 25, 5);
  ChainConstraints constraints;
  constraints.factorise(chains.position, 5);
  Vec3 centre = Vec3::Zero(), restored = Vec3::Zero();
  for (const NodeIndex k : chains.nodes()) {
    const auto u = uniform4(9, RandomStream::noise, {static_cast<std::uint32_t>(k.value()), 0, 0});
    chains.position[k] += 0.1 * Vec3(u[0] - 0.5, u[1] - 0.5, u[2] - 0.5);
    centre += chains.position[k];
  }
  const auto worst = [&chains] {
    double error = 0;
    for (const RodIndex rod : chains.rods(FiberIndex(0)))
      error = std::max(error, std::abs(chains.axis(rod).norm() - 5));
    return error;
  };
  EXPECT_GT(worst(), 1e-2);
  constraints.restore_lengths(chains.position.data());
  EXPECT_LT(worst(), 1e-4);  // two corrections with the old directions: the error times the turn, twice
  constraints.restore_lengths(chains.position.data(), 10);
  EXPECT_LT(worst(), 1e-13);
  for (const Vec3& x : chains.position) restored += x;
  EXPECT_LT((centre - restored).norm(), 1e-10);
}

}  // namespace
}  // namespace fiberfate
