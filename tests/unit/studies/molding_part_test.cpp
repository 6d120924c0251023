// Tests the parts that a case describes: volumes, gates, bending without stretching.
#include "studies/molding/part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "molding/gate_nodes.hpp"

namespace fiberfate {
namespace {

PartChoices plaque() {
  PartChoices part;
  part.length = 0.1;
  part.width = 0.04;
  part.thickness = 2e-3;
  part.mesh_size = 8e-3;
  return part;
}

double volume(const PartChoices& part) {
  return ShellMesh(make_part(part).shell).total_volume();
}

TEST(MoldingPart, HasTheVolumeOfItsDrawing) {
  EXPECT_NEAR(volume(plaque()), 0.1 * 0.04 * 2e-3, 1e-18);
  PartChoices frame = plaque();
  frame.kind = PartKind::frame;
  frame.opening_length = 0.03;
  frame.opening_width = 0.02;
  EXPECT_NEAR(volume(frame), (0.1 * 0.04 - 0.03 * 0.02) * 2e-3, 1e-18);
  PartChoices ribbed = plaque();
  ribbed.kind = PartKind::ribbed;
  ribbed.thicknesses = {{"rib", {1e-3}}};
  ribbed.rib_height = 0.01;
  EXPECT_NEAR(volume(ribbed), 0.1 * 0.04 * 2e-3 + 2 * 0.08 * 0.01 * 1e-3, 1e-18);
}

/// The time that the mesh took would differ.
TEST(MoldingPart, IsMeshedOnce) {
  const MoldingPart first = make_part(plaque());
  PartChoices wider = plaque();
  wider.width = 0.05;
  const double other = make_part(wider).meshing_s;
  PartChoices thicker = plaque();
  thicker.thickness = 3e-3;
  const MoldingPart second = make_part(thicker);
  EXPECT_GT(first.meshing_s, 0);
  EXPECT_EQ(first.meshing_s, second.meshing_s);
  EXPECT_NE(first.meshing_s, other);
  EXPECT_EQ(first.shell.nodes, second.shell.nodes);
  EXPECT_EQ(second.shell.thickness.front(), 3e-3);
}

TEST(MoldingPart, OfADiscIsAPolygon) {
  PartChoices disc = plaque();
  disc.kind = PartKind::disc;
  disc.diameter = 0.1;
  const double sides = std::round(pi * 0.1 / disc.mesh_size);
  EXPECT_NEAR(volume(disc), 0.5 * sides * 0.05 * 0.05 * std::sin(2 * pi / sides) * 2e-3, 1e-15);
}

TEST(MoldingPart, TailgateHasTheVolumeAskedFor) {
  PartChoices tailgate = plaque();
  tailgate.kind = PartKind::tailgate;
  tailgate.volume = 4933e-6;
  tailgate.thickness = 3e-3;
  tailgate.mesh_size = 0.04;
  tailgate.gate_radius = 4e-3;
  const MoldingPart part = make_part(tailgate);
  const ShellMesh mesh(part.shell);
  // Chords across the bend, of radius 0.38 m, are shorter than its arc by (size/radius)²/24 there: 1e-4 of
  // the part.
  EXPECT_NEAR(mesh.total_volume(), 4933e-6, 2e-4 * 4933e-6);
  ASSERT_EQ(part.gates.size(), 9U);
  for (const Gate& gate : part.gates) EXPECT_LT(distance_from_part(gate, mesh), 1e-9) << gate.name;
}

TEST(MoldingPart, KeepsItsLengthsWhenItIsBent) {
  PartChoices bent = plaque();
  bent.mesh_size = 4e-3;
  bent.bend_radius = 0.05;
  const MoldingPart part = make_part(bent);
  EXPECT_NEAR(ShellMesh(part.shell).total_volume(), 0.1 * 0.04 * 2e-3, 5e-4 * 8e-6);
  EXPECT_LT((part.place({0.0, 0.01}) - Vec3(0, 0.01, 0)).norm(), 1e-15);
  EXPECT_NEAR(part.place({0.05 * pi / 2, 0}).x(), 0.05, 1e-15);
  EXPECT_NEAR(part.place({0.05 * pi / 2, 0}).z(), 0.05, 1e-15);
}

TEST(MoldingPart, FanLeadsFromItsThicknessToThatOfThePart) {
  PartChoices fan = plaque();
  fan.gate = PartGate::fan;
  fan.gate_width = 0.01;
  fan.fan_length = 0.02;
  fan.fan_thickness = 4e-3;
  const MoldingPart part = make_part(fan);
  ASSERT_EQ(part.regions.size(), 2U);
  const auto [thinnest, thickest] =
      std::minmax_element(part.shell.thickness.begin(), part.shell.thickness.end());
  EXPECT_EQ(*thinnest, 2e-3);
  EXPECT_GT(*thickest, 3.5e-3);
  EXPECT_LE(*thickest, 4e-3);
  ASSERT_EQ(part.gates.size(), 1U);
  EXPECT_EQ(part.gates[0].position.x(), -0.02);
}

TEST(MoldingPart, FollowsAThicknessProfile) {
  PartChoices part = plaque();
  part.thickness_profile = {{0, 1}, {0.1, 0.5}};
  // The mean of a thickness that falls linearly to one half.
  EXPECT_NEAR(volume(part), 0.1 * 0.04 * 2e-3 * 0.75, 1e-18);
}

TEST(MoldingPart, RefusesRegionsThatItDoesNotHave) {
  PartChoices part = plaque();
  part.thicknesses = {{"rib", {1e-3}}};
  EXPECT_THROW((void)make_part(part), InputError);
}

}  // namespace
}  // namespace fiberfate
