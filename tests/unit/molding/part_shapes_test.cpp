// Tests drawings of parts: their patches, their gates, and how they bend.
#include "molding/part_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fiberfate {
namespace {

PartOutline plaque() {
  PartOutline part;
  part.length = 0.1;
  part.width = 0.04;
  part.thickness = 2e-3;
  return part;
}

/// Area of a patch in the plane of the drawing: its outer loop less the others.
double area(const PatchedSurface& surface, const Patch& patch) {
  double sum = 0;
  for (const auto& loop : patch.loops) {
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 &a = surface.corners[loop[i]], &b = surface.corners[loop[(i + 1) % loop.size()]];
      twice += a[0] * b[1] - b[0] * a[1];
    }
    sum += (&loop == &patch.loops.front() ? 0.5 : -0.5) * std::abs(twice);
  }
  return sum;
}

TEST(PartShapes, PatchesHaveTheAreaAskedFor) {
  PartOutline part = plaque();
  PartShape shape = draw_part(part);
  EXPECT_NEAR(area(shape.surface, shape.surface.patches.at(0)), 0.1 * 0.04, 1e-15);
  part.kind = PartKind::frame;
  part.opening_length = 0.05;
  part.opening_width = 0.02;
  shape = draw_part(part);
  EXPECT_NEAR(area(shape.surface, shape.surface.patches.at(0)), 0.1 * 0.04 - 0.05 * 0.02, 1e-15);
  part.kind = PartKind::tailgate;
  part.volume = 4933e-6;
  part.thickness = 3e-3;
  shape = draw_part(part);
  EXPECT_NEAR(area(shape.surface, shape.surface.patches.at(0)) * 3e-3, 4933e-6, 1e-12);
  EXPECT_EQ(shape.gates.size(), 9u);
}

TEST(PartShapes, RibsStandOnThePlate) {
  PartOutline part = plaque();
  part.kind = PartKind::ribbed;
  part.ribs = 3;
  const PartShape shape = draw_part(part);
  ASSERT_EQ(shape.surface.patches.size(), 4u);
  EXPECT_EQ(shape.surface.patches[0].inner_edges.size(), 3u);
  for (std::size_t rib = 1; rib < 4; ++rib) EXPECT_EQ(shape.surface.patches[rib].region, "rib");
}

TEST(PartShapes, GatesLieWhereTold) {
  PartOutline part = plaque();
  part.gate_width = 0.01;
  EXPECT_NEAR((draw_part(part).gates.at(0).position - Vec3(0, 0.015, 0)).norm(), 0, 1e-15);
  part.gate = PartGate::centre;
  EXPECT_NEAR((draw_part(part).gates.at(0).position - Vec3(0.05, 0.02, 0)).norm(), 0, 1e-15);
  part.gate = PartGate::given;
  EXPECT_TRUE(draw_part(part).gates.empty());
}

/// Rolling keeps lengths along the surface: an arc of x on the cylinder, all of y, and z to its axis.
TEST(PartShapes, BendingStretchesNothing) {
  PartOutline part = plaque();
  part.bend_radius = 0.05;
  const auto place = draw_part(part).place;
  EXPECT_NEAR((place({0.05, 0.01, 0}) - Vec3(0.05 * std::sin(1), 0.01, 0.05 * (1 - std::cos(1)))).norm(), 0,
              1e-15);
  const double step = 1e-5;
  for (const double x : {0.0, 0.03, 0.09})
    EXPECT_NEAR((place({x + step, 0, 0}) - place({x, 0, 0})).norm() / step, 1, 1e-8);
}

}  // namespace
}  // namespace fiberfate
