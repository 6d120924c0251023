// Tests the resistance of a rod by each law.
#include "dynamics/drag.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.hpp"

namespace fiberfate {
namespace {

constexpr double radius = 9.5e-6;

/// Turning resistance of beads at s_k: sum over them of 6 pi eta a s_k² + 8 pi eta a³, for eta = 1.
double sum_over_beads(int beads) {
  double sum = 0;
  for (int k = 0; k < beads; ++k) {
    const double s = (2 * k - beads + 1) * radius;
    sum += 6 * pi * radius * s * s + 8 * pi * std::pow(radius, 3);
  }
  return sum;
}

TEST(BeadDrag, IsTheSumOverTheBeads) {
  for (const int beads : {1, 2, 7, 131}) {
    const RodDrag drag = BeadDrag{1.0}({.length = 2 * radius * beads, .radius = radius});
    EXPECT_NEAR(drag.parallel, 6 * pi * radius * beads, 1e-12 * drag.parallel);
    EXPECT_EQ(drag.parallel, drag.perpendicular);
    EXPECT_NEAR(drag.rotational, sum_over_beads(beads), 1e-12 * drag.rotational);
    const double m = beads;
    EXPECT_NEAR(drag.shape, (m * m - 1) / (m * m + 3), 1e-12);
  }
}

TEST(BeadDrag, GrowsWithViscosityAlone) {
  const RodDrag one = BeadDrag{1.0}({.length = 1e-4, .radius = radius});
  const RodDrag many = BeadDrag{300.0}({.length = 1e-4, .radius = radius});
  EXPECT_NEAR(many.rotational, 300 * one.rotational, 1e-12 * many.rotational);
  EXPECT_EQ(many.shape, one.shape);
}

TEST(IntegerBeadDrag, CountsWholeBeadsAndNotTheirRoundOff) {
  const IntegerBeadDrag law{1.0};
  const double one = 6 * pi * radius;
  EXPECT_NEAR(law({.length = 2 * radius * 4.99, .radius = radius}).parallel, 4 * one, 1e-12);
  EXPECT_NEAR(law({.length = 2 * radius * 5 * (1 - 1e-15), .radius = radius}).parallel, 5 * one, 1e-12);
  EXPECT_NEAR(law({.length = 2 * radius * 0.9, .radius = radius}).parallel, one, 1e-12);
}

TEST(RodDrag, IsChosenByName) {
  const RodShape rod{.length = 3.3e-4, .radius = radius};
  EXPECT_EQ(rod_drag(DragLaw::beads, 2, rod).rotational, BeadDrag{2}(rod).rotational);
  EXPECT_EQ(rod_drag(DragLaw::beads_integer, 2, rod).rotational, IntegerBeadDrag{2}(rod).rotational);
  EXPECT_EQ(rod_drag(DragLaw::ellipsoid, 2, rod).rotational, EllipsoidDrag{2}(rod).rotational);
}

}  // namespace
}  // namespace fiberfate
