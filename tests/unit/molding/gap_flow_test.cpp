// Tests layers and the flow through them against integrals.
#include "molding/gap_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {
namespace {

TEST(GapLayers, GrowFinerTowardsTheWall) {
  const GapLayers layers(10, 0.4);
  EXPECT_EQ(layers.count(), 10u);
  EXPECT_EQ(layers.bounds().front(), 0);
  EXPECT_EQ(layers.bounds().back(), 1);
  EXPECT_NEAR(layers.widths().back() / layers.widths().front(), 0.4, 1e-14);
  EXPECT_NEAR(std::accumulate(layers.widths().begin(), layers.widths().end(), 0.0), 1, 1e-14);
  EXPECT_THROW(GapLayers(1, 0.4), InputError);
  EXPECT_THROW(GapLayers(65, 0.4), InputError);
  EXPECT_THROW(GapLayers(10, 0), InputError);
}

TEST(GapLayers, TheMiddleOneMayBeThinner) {
  const GapLayers plain(10, 0.4), thin(10, 0.4, 0.25);
  EXPECT_NEAR(thin.widths()[0] / thin.widths()[1], 0.25 * plain.widths()[0] / plain.widths()[1], 1e-14);
  for (std::size_t k = 2; k < 10; ++k)
    EXPECT_NEAR(thin.widths()[k] / thin.widths()[1], plain.widths()[k] / plain.widths()[1], 1e-14);
  EXPECT_EQ(thin.bounds().back(), 1);
  EXPECT_NEAR(std::accumulate(thin.widths().begin(), thin.widths().end(), 0.0), 1, 1e-14);
  EXPECT_THROW(GapLayers(10, 0.4, 0), InputError);
  EXPECT_THROW(GapLayers(10, 0.4, 1.5), InputError);
}

/// One viscosity: s = 1/(3 eta), v ~ 1 - zeta².
TEST(GapFlow, OneViscosityIsExactOnAnyLayers) {
  for (const int count : {2, 7}) {
    const GapLayers layers(count, 0.3);
    std::vector<double> inverse(layers.count(), 1.0 / 50), shares(layers.count());
    EXPECT_NEAR(flow_through_gap(layers, inverse, shares), 1.0 / 150, 1e-17);
    for (std::size_t k = 0; k < layers.count(); ++k) {
      const double a = layers.bounds()[k], b = layers.bounds()[k + 1];
      EXPECT_NEAR(shares[k], 1.5 * ((b - a) - (b * b * b - a * a * a) / 3), 1e-14);
    }
  }
}

/// Two viscosities: int zeta²/eta dzeta, layer by layer; a frozen wall layer leaves a gap of its inner bound.
TEST(GapFlow, SteppedViscosityAndFrozenLayersAreExact) {
  const GapLayers layers(2, 1);
  std::vector<double> shares(2);
  EXPECT_NEAR(flow_through_gap(layers, std::vector<double>{0.5, 0.25}, shares),
              0.5 * 0.125 / 3 + 0.25 * (1 - 0.125) / 3, 1e-16);
  EXPECT_NEAR(flow_through_gap(layers, std::vector<double>{0.5, 0}, shares), 0.5 * 0.125 / 3, 1e-16);
  EXPECT_EQ(shares[1], 0);
  EXPECT_NEAR(shares[0], 1, 1e-15);
  EXPECT_EQ(flow_through_gap(layers, std::vector<double>{0, 0}, shares), 0);
  EXPECT_EQ(shares[0], 1);
}

TEST(GapFlow, HeatOfFlowSumsToOneAndSitsAtTheWall) {
  const GapLayers layers(8, 0.4);
  std::vector<double> shares(8);
  dissipation_shares(layers, std::vector<double>(8, 0.01), shares);
  double sum = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    const double a = layers.bounds()[k], b = layers.bounds()[k + 1];
    EXPECT_NEAR(shares[k], b * b * b - a * a * a, 1e-14);
    sum += shares[k];
  }
  EXPECT_NEAR(sum, 1, 1e-14);
}

}  // namespace
}  // namespace fiberfate
