// Tests the balance of layers in a step and the order of nodes down the flow.
#include "molding/step_flow.hpp"

#include <gtest/gtest.h>

namespace fiberfate {
namespace {

/// A row of four nodes: 0 feeds 1, 1 feeds 2 (and 3 beside it).
struct Row {
  ShellMesh mesh{
      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}, {0.002, 0.002}, {}, {}}};
  GapLayers layers{4, 1};
  FlowField field;
  StepFlow step;
  Row() {
    step.edge_volume.assign(mesh.edges().size(), 0);
    step.gate_volume = {1, 0, 0, 0};
    step.gate = {0, -1, -1, -1};
    step.at_front = {0, 0, 1, 0};
    step.content = {1, 1, 0.5, 1};
    step.new_content = {1, 1, 1.5, 1};
    flow(0, 1, 1);
    flow(1, 2, 1);
    field.shares.assign(16, 0);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 4; ++k) field.shares[i * 4 + k] = 0.4 - 0.1 * static_cast<double>(k);
  }
  void flow(Index from, Index to, double volume) {
    for (std::size_t e = 0; e < mesh.edges().size(); ++e) {
      if (mesh.edges()[e].first == from && mesh.edges()[e].second == to) step.edge_volume[e] = volume;
      if (mesh.edges()[e].first == to && mesh.edges()[e].second == from) step.edge_volume[e] = -volume;
    }
  }
};

TEST(StepFlow, NodesComeAfterThoseThatFeedThem) {
  Row row;
  sort_into_levels(row.mesh, row.step);
  ASSERT_EQ(row.step.level_begin.size(), 4u);
  EXPECT_EQ(row.step.order, (std::vector<Index>{0, 3, 1, 2}));
}

/// At the front the surplus of the mid-plane (7/16 of the flow where it needs 1/4) goes to the wall,
/// which gets 1/16, and the next layer's to the next.
TEST(StepFlow, FountainTakesTheMidPlaneToTheWall) {
  Row row;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) row.field.shares[i * 4 + k] = (7 - 2 * static_cast<double>(k)) / 16;
  sort_into_levels(row.mesh, row.step);
  split_by_layers({row.mesh, row.layers}, row.field, row.step);
  const auto transfers = row.step.transfers_of(2, 4);
  ASSERT_EQ(transfers.size(), 2u);
  EXPECT_EQ(transfers[0].from, 0);
  EXPECT_EQ(transfers[0].to, 3);
  EXPECT_EQ(transfers[0].volume, 3.0 / 16);
  EXPECT_EQ(transfers[1].from, 1);
  EXPECT_EQ(transfers[1].to, 2);
  EXPECT_EQ(transfers[1].volume, 1.0 / 16);
  EXPECT_EQ(row.step.layer_inflow[2 * 4 + 3], 0.25);
}

/// Behind the front a change of the profile moves melt to the neighbouring layers only.
TEST(StepFlow, ProfilesThatChangeMoveMeltFromLayerToLayer) {
  Row row;
  for (std::size_t k = 0; k < 4; ++k) row.field.shares[k] = 0.25;  // plug flow at the gate
  sort_into_levels(row.mesh, row.step);
  split_by_layers({row.mesh, row.layers}, row.field, row.step);
  double up_to = 0;
  for (const LayerTransfer& t : row.step.transfers_of(1, 4)) {
    EXPECT_EQ(t.from, t.to + 1);  // the core runs ahead and draws from outside
    const std::size_t k = t.to;
    const double in = 0.5 * (0.25 + row.field.shares[4 + k]), out = row.field.shares[4 + k];
    up_to += in - out;
    EXPECT_NEAR(t.volume, -up_to, 1e-15);
  }
  EXPECT_EQ(row.step.transfer_count[1], 3);
}

}  // namespace
}  // namespace fiberfate
