// Tests the resistance of a rod by each law.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "dynamics/drag_laws/beads.hpp"
#include "dynamics/drag_laws/drag_registry.hpp"
#include "dynamics/drag_laws/ellipsoid.hpp"
#include "dynamics/drag_laws/slender_body.hpp"

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
    const RodDrag drag = BeadDrag{1.0}({.length = 2 * radius * beads, .radius = radius, .fiber_length = 0});
    EXPECT_NEAR(drag.parallel, 6 * pi * radius * beads, 1e-12 * drag.parallel);
    EXPECT_EQ(drag.parallel, drag.perpendicular);
    EXPECT_NEAR(drag.rotational, sum_over_beads(beads), 1e-12 * drag.rotational);
    const double m = beads;
    EXPECT_NEAR(drag.shape, (m * m - 1) / (m * m + 3), 1e-12);
  }
}

TEST(BeadDrag, GrowsWithViscosityAlone) {
  const RodDrag one = BeadDrag{1.0}({.length = 1e-4, .radius = radius, .fiber_length = 0});
  const RodDrag many = BeadDrag{300.0}({.length = 1e-4, .radius = radius, .fiber_length = 0});
  EXPECT_NEAR(many.rotational, 300 * one.rotational, 1e-12 * many.rotational);
  EXPECT_EQ(many.shape, one.shape);
}

TEST(IntegerBeadDrag, CountsWholeBeadsAndNotTheirRoundOff) {
  const IntegerBeadDrag law{1.0};
  const double one = 6 * pi * radius;
  EXPECT_NEAR(law({.length = 2 * radius * 4.99, .radius = radius, .fiber_length = 0}).parallel, 4 * one,
              1e-12);
  EXPECT_NEAR(law({.length = 2 * radius * 5 * (1 - 1e-15), .radius = radius, .fiber_length = 0}).parallel,
              5 * one, 1e-12);
  EXPECT_NEAR(law({.length = 2 * radius * 0.9, .radius = radius, .fiber_length = 0}).parallel, one, 1e-12);
}

/// All six resistances of an ellipsoid of a given eccentricity, over those of the sphere around it.
std::array<double, 6> over_sphere(double eccentricity) {
  const double major = radius / std::sqrt(1 - eccentricity * eccentricity);
  const RodDrag drag = EllipsoidDrag{1.0}({.length = 2 * major, .radius = radius, .fiber_length = 0});
  const double cube = pi * std::pow(major, 3);
  return {drag.parallel / (6 * pi * major),       drag.perpendicular / (6 * pi * major),
          drag.rotational / (8 * cube),           drag.strain.along / (10 * cube),
          drag.strain.aslant / (40.0 / 3 * cube), drag.strain.across / (20.0 / 3 * cube)};
}

TEST(EllipsoidDrag, BecomesThatOfASphereWithoutALeap) {
  for (const double value : over_sphere(0)) EXPECT_NEAR(value, 1, 4e-16);  // pi rounds
  for (const double value : over_sphere(1e-7)) EXPECT_NEAR(value, 1, 1e-13);
  const std::array below = over_sphere(0.08 * (1 - 1e-9)), above = over_sphere(0.08 * (1 + 1e-9));
  for (std::size_t i = 0; i < below.size(); ++i) EXPECT_NEAR(below[i], above[i], 5e-10) << i;
}

/// Batchelor's resistances per length of a fiber of aspect ratio r, over the viscosity.
double theory_across(double r) {
  return 4 * pi / (std::log(2 * r) + 0.193);
}
double theory_along(double r) {
  return 2 * pi / (std::log(2 * r) - 0.807);
}

TEST(SlenderBodyDrag, IsBatchelorsForTheWholeFiber) {
  for (const double r : {5.0, 20.0, 131.0, 1000.0}) {
    const double whole = 2 * radius * r;
    for (const double length : {whole, whole / 7}) {
      const RodDrag drag = SlenderBodyDrag{3}({length, radius, whole});
      EXPECT_NEAR(drag.perpendicular, 3 * theory_across(r) * length, 1e-12 * drag.perpendicular);
      EXPECT_NEAR(drag.parallel, 3 * theory_along(r) * length, 1e-12 * drag.parallel);
    }
  }
}

// At r = 131 beads are 4.3 times too stiff across and 7.1 along: 3 pi eta per length in every direction.
TEST(SlenderBodyDrag, IsFarBelowThatOfBeads) {
  const RodShape rod{2 * radius * 131, radius, 0};
  const RodDrag beads = BeadDrag{1}(rod), slender = SlenderBodyDrag{1}(rod);
  EXPECT_NEAR(beads.perpendicular / slender.perpendicular, 4.3, 0.05);
  EXPECT_NEAR(beads.parallel / slender.parallel, 7.1, 0.05);
}

// A rod of the fiber's length is the fiber; below r = 3.05 Batchelor's formulas would cross, and fail at 1.1.
TEST(SlenderBodyDrag, NeverResistsMoreAlongThanAcross) {
  for (const double r : {1.0, 1.12, 2.0, 3.0, 3.1, 10.0}) {
    const RodDrag drag = SlenderBodyDrag{1}({2 * radius * r, radius, 0});
    EXPECT_GT(drag.parallel, 0) << r;
    EXPECT_LE(drag.parallel, drag.perpendicular * (1 + 1e-12)) << r;
    EXPECT_GT(drag.rotational, 0) << r;
    EXPECT_LT(drag.shape, 1) << r;
  }
}

/// Resistance of n equal rods in a row to turning about their middle, and what the strain drives of it.
struct Turning {
  double resistance = 0, driven = 0;
};
Turning turning_of_rods(const DragRow& law, double whole, int rods) {
  Turning sum;
  const double length = whole / rods;
  for (int i = 0; i < rods; ++i) {
    const RodDrag drag = law.drag(1, {length, radius, whole});
    const double centre = (i + 0.5) * length - whole / 2;
    const double lever = drag.perpendicular * centre * centre;
    sum.resistance += drag.rotational + lever;
    sum.driven += drag.rotational * drag.shape + lever;
  }
  return sum;
}

// However a straight fiber is cut, it resists turning alike and tumbles with the same aspect ratio.
TEST(DragLaws, AddUpOverTheRodsOfAStraightFiber) {
  for (const char* name : {"beads", "slender_body"}) {
    const double whole = 2 * radius * 60;
    const Turning one = turning_of_rods(drag_law_named(name), whole, 1);
    for (const int rods : {2, 7, 20}) {
      const Turning many = turning_of_rods(drag_law_named(name), whole, rods);
      EXPECT_NEAR(many.resistance, one.resistance, 1e-12 * one.resistance) << name;
      EXPECT_NEAR(many.driven, one.driven, 1e-12 * one.driven) << name;
    }
  }
}

// What the loops rely on: positive resistances, in proportion to the viscosity, and a free rod that turns as
// some spheroid does.
TEST(DragLaws, ResistInEveryDirection) {
  for (const DragRow& row : drag_laws()) {
    for (const double beads : {1.3, 5.0, 100.0}) {
      const RodShape rod{2 * radius * beads, radius, 2 * radius * 131};
      const RodDrag drag = row.drag(1, rod), thick = row.drag(300, rod);
      EXPECT_GT(drag.parallel, 0) << row.text.name;
      EXPECT_GT(drag.perpendicular, 0) << row.text.name;
      EXPECT_GT(drag.rotational, 0) << row.text.name;
      EXPECT_LT(std::abs(drag.shape), 1) << row.text.name;
      EXPECT_NEAR(thick.rotational, 300 * drag.rotational, 1e-12 * thick.rotational) << row.text.name;
      EXPECT_NEAR(thick.strain.along, 300 * drag.strain.along, 1e-12 * thick.strain.along) << row.text.name;
    }
  }
}

TEST(DragLaws, AreChosenByName) {
  const RodShape rod{.length = 3.3e-4, .radius = radius, .fiber_length = 0};
  EXPECT_EQ(drag_law_named("beads").drag(2, rod).rotational, BeadDrag{2}(rod).rotational);
  EXPECT_EQ(drag_law_named("beads_integer").drag(2, rod).rotational, IntegerBeadDrag{2}(rod).rotational);
  EXPECT_EQ(drag_law_named("ellipsoid").drag(2, rod).rotational, EllipsoidDrag{2}(rod).rotational);
  EXPECT_THROW((void)drag_law_named("bead"), InputError);
}

}  // namespace
}  // namespace fiberfate
