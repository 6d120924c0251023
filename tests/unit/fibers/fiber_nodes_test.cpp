// Tests which nodes, rods and hinges a fiber has.
#include "fibers/fiber_nodes.hpp"

#include <gtest/gtest.h>

#include <concepts>
#include <vector>

#include "fibers/state.hpp"

namespace fiberfate {
namespace {

static_assert(!std::constructible_from<NodeIndex, RodIndex> && !std::constructible_from<RodIndex, NodeIndex>);
static_assert(!std::constructible_from<FiberIndex, NodeIndex> &&
              !std::constructible_from<NodeIndex, FiberIndex>);
static_assert(std::invocable<decltype(fiber_length), const FiberState&, FiberIndex>);
static_assert(!std::invocable<decltype(fiber_length), const FiberState&, NodeIndex>);
static_assert(!std::invocable<decltype(fiber_length), const FiberState&, int>);

/// A fiber of three rods along x and one of a single rod along y.
FiberNodes two_fibers() {
  FiberNodes fibers;
  fibers.position = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {6, 0, 0}, {0, 1, 0}, {0, 3, 0}};
  fibers.first_node = {NodeIndex(0), NodeIndex(4), NodeIndex(6)};
  return fibers;
}

template <class I>
std::vector<Index> listed(IndexRange<I> range) {
  std::vector<Index> values;
  for (const I one : range) values.push_back(one.value());
  return values;
}

TEST(FiberNodes, NumberRodsByTheirFirstNodes) {
  const FiberNodes fibers = two_fibers();
  EXPECT_EQ(listed(fibers.fibers()), (std::vector<Index>{0, 1}));
  EXPECT_EQ(listed(fibers.nodes(FiberIndex(0))), (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(listed(fibers.rods(FiberIndex(0))), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(listed(fibers.hinges(FiberIndex(0))), (std::vector<Index>{1, 2}));
  EXPECT_EQ(listed(fibers.rods(FiberIndex(1))), (std::vector<Index>{4}));
  EXPECT_TRUE(listed(fibers.hinges(FiberIndex(1))).empty());
  EXPECT_EQ(fibers.rod_count(), 4);
  EXPECT_EQ(fibers.last_node(FiberIndex(1)), NodeIndex(5));
}

TEST(FiberNodes, BoundRods) {
  const FiberNodes fibers = two_fibers();
  const RodIndex rod(1);
  EXPECT_EQ(rod_after(first_end(rod)), rod);
  EXPECT_EQ(rod_before(second_end(rod)), rod);
  EXPECT_EQ(fibers.axis(rod), Vec3(2, 0, 0));
  EXPECT_EQ(fibers.centre(rod), Vec3(2, 0, 0));
  EXPECT_EQ(fibers.segment(rod).end, Vec3(3, 0, 0));
  EXPECT_EQ(fibers.positions(FiberIndex(1)).front(), Vec3(0, 1, 0));
  EXPECT_EQ(fibers.positions(FiberIndex(1)).size(), 2u);
}

}  // namespace
}  // namespace fiberfate
