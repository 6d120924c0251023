// Finds weld lines, air traps and the order of filling.
#include <gtest/gtest.h>

#include "molding/weld_lines.hpp"
#include "test_shells.hpp"

namespace fiberfate {
namespace {

using namespace test;

FillingParams newtonian(double rate, const Gate& gate) {
  return isothermal(rate, viscosity("newtonian", {100}), gate);
}

/// Two fronts from the ends of a strip meet in its middle.
TEST(FrontMarks, FrontsThatMeetLeaveAWeldLine) {
  const Rectangle r{0.08, 0.01, 0.002, 41, 4};
  FillingParams params = newtonian(1e-6, film_gate({0, 0, 0}, {0, r.width, 0}));
  params.gates.push_back(film_gate({r.length, 0, 0}, {r.length, r.width, 0}));
  Filling filling{ShellMesh(rectangle(r)), params};
  filling.run_to_end();
  int welds = 0;
  for (std::size_t i = 0; i < filling.mesh().node_count(); ++i) {
    const double x = filling.mesh().shell().nodes[i][0];
    if (filling.state().mark[i] == NodeMark::none) continue;
    EXPECT_NEAR(x, 0.04, 0.004);
    ++welds;
  }
  EXPECT_GE(welds, 5);
}

/// Two round fronts in a plate leave one straight line across its middle, of the plate's width, and trap air
/// at most where the line ends: unevenness of the fronts along it is no pocket.
TEST(FrontMarks, RoundFrontsLeaveOneStraightLineWithoutTraps) {
  const Rectangle r{0.08, 0.04, 0.003, 40, 20};
  FillingParams params = newtonian(1e-6, round_gate({0, 0.5 * r.width, 0}));
  params.gates.push_back(round_gate({r.length, 0.5 * r.width, 0}));
  Filling filling{ShellMesh(rectangle(r)), params};
  filling.run_to_end();
  double length = 0;
  for (const LinePiece& piece : weld_lines(filling.mesh(), filling.state())) {
    for (const Vec3& end : piece) EXPECT_NEAR(end[0], 0.04, 0.003);
    length += std::abs(piece[1][1] - piece[0][1]);
  }
  EXPECT_NEAR(length, r.width, 0.15 * r.width);
  for (std::size_t i = 0; i < filling.mesh().node_count(); ++i) {
    const double y = filling.mesh().shell().nodes[i][1];
    if (filling.state().mark[i] == NodeMark::air_trap) {
      EXPECT_GT(std::abs(y - 0.02), 0.016);
    }
  }
}

/// A front that runs along a strip leaves no weld line; its times rise with x.
TEST(FrontMarks, APlaneFrontLeavesNoWeldLine) {
  const Rectangle r{0.08, 0.01, 0.002, 40, 4};
  int last = 0;
  Filling filling{ShellMesh(rectangle(r)), newtonian(1e-6, film_gate({0, 0, 0}, {0, r.width, 0}))};
  filling.run_to_end();
  for (std::size_t i = 0; i < filling.mesh().node_count(); ++i) {
    const double x = filling.mesh().shell().nodes[i][0];
    EXPECT_NE(filling.state().mark[i], NodeMark::weld_line);
    if (filling.state().mark[i] == NodeMark::last_filled) {
      EXPECT_NEAR(x, r.length, 1e-12);
      ++last;
    }
    // A control volume at the end is half filled at a quarter of a cell from the end.
    const double middle = std::clamp(x, 0.0005, 0.0795);
    EXPECT_NEAR(filling.state().fill_time[i], middle * r.width * r.thickness / 1e-6, 0.01);
  }
  EXPECT_EQ(last, 1);
}

/// A slow thin window in a thick frame fills last, from all sides: the air in it is trapped.
TEST(FrontMarks, ASlowRegionTrapsAir) {
  const Rectangle r{0.06, 0.06, 0.003, 30, 30};
  Shell shell = rectangle(r);
  for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
    Vec3 centre = Vec3::Zero();
    for (const Index node : shell.triangles[t]) centre += shell.nodes[node] / 3;
    if ((centre - Vec3(0.03, 0.03, 0)).norm() < 0.012) shell.thickness[t] = 0.0008;
  }
  Filling filling{ShellMesh(shell), newtonian(1e-6, film_gate({0, 0, 0}, {0, r.width, 0}))};
  filling.run_to_end();
  bool trapped = false;
  for (std::size_t i = 0; i < filling.mesh().node_count(); ++i) {
    const Vec3& x = filling.mesh().shell().nodes[i];
    trapped = trapped ||
              ((x - Vec3(0.03, 0.03, 0)).norm() < 0.012 && filling.state().mark[i] == NodeMark::air_trap);
  }
  EXPECT_TRUE(trapped);
}

}  // namespace
}  // namespace fiberfate
