// Tests that loads are grouped by rod in an order that does not depend on how they came.
#include "dynamics/rod_loads.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace fiberfate {
namespace {

std::vector<double> levers_of(const RodLoads& loads, int rod) {
  std::vector<double> levers;
  for (const RodLoad& load : loads.of_rod(RodIndex(rod))) levers.push_back(load.lever);
  return levers;
}

RodLoads arrange(const std::vector<RodLoads::Claim>& claims) {
  RodLoads loads;
  std::vector<RodLoads::Slot> slots;
  loads.arrange(5, claims, slots);
  for (std::size_t i = 0; i < claims.size(); ++i) loads.slot(slots[i]).lever = 0.01 * double(claims[i].key);
  return loads;
}

TEST(RodLoads, AreGroupedByRodAndOrderedByKey) {
  std::vector<RodLoads::Claim> claims = {{RodIndex(3), 9}, {RodIndex(0), 5}, {RodIndex(3), 2},
                                         {RodIndex(3), 7}, {RodIndex(1), 1}, {RodIndex(0), 3}};
  for (int order = 0; order < 6; ++order) {
    std::rotate(claims.begin(), claims.begin() + 1, claims.end());
    const RodLoads loads = arrange(claims);
    EXPECT_EQ(levers_of(loads, 0), (std::vector<double>{0.03, 0.05}));
    EXPECT_EQ(levers_of(loads, 1), (std::vector<double>{0.01}));
    EXPECT_TRUE(levers_of(loads, 2).empty());
    EXPECT_EQ(levers_of(loads, 3), (std::vector<double>{0.02, 0.07, 0.09}));
    EXPECT_TRUE(levers_of(loads, 4).empty());
  }
}

TEST(RodLoads, AreNoneToBeginWith) {
  const RodLoads loads;
  for (const int rod : {0, 1, 2}) EXPECT_TRUE(loads.of_rod(RodIndex(rod)).empty());
}

}  // namespace
}  // namespace fiberfate
