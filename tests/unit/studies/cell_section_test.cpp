// Checks what of a large cell a report shows: no more than fits on a page, and it says so.
#include "studies/sample/cell_section.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "results/fiber_frame.hpp"

namespace fiberfate {
namespace {

constexpr int fibers = 30;
constexpr int nodes = 6;

/// A file of straight fibers in a cube of 1 mm at every millisecond; the test's own, removed at its end.
class Frames {
 public:
  explicit Frames(int count) : path_(::testing::TempDir() + "cell_section_test.vtkhdf") {
    VtkhdfWriter writer(path_, 0);
    for (int k = 0; k < count; ++k) writer.append(frame(1e-3 * k));
    writer.finish();
  }
  ~Frames() { std::filesystem::remove(path_); }
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;

  [[nodiscard]] VtkhdfReader open() const { return VtkhdfReader(path_); }

 private:
  static PolyFrame frame(double time) {
    FiberState state;
    state.time = time;
    state.cell.lattice = 1e-3 * Mat3::Identity();
    state.materials = {{9.5e-6, 73e9, 2550}};
    for (int fiber = 0; fiber < fibers; ++fiber) {
      std::vector<Vec3> places;
      for (int node = 0; node < nodes; ++node) places.emplace_back(1e-4 * node, 3e-5 * fiber, 2e-5 * fiber);
      append_fiber(state, {places, 0});
    }
    for (int fiber = 0; fiber < fibers; ++fiber)
      state.birth_id[FiberIndex(fiber)] = static_cast<std::uint32_t>(fiber);
    return fiber_frame(state);
  }
  std::string path_;
};

/// Bytes that a section has before they become text.
double bytes_of(const FibersSection& section) {
  double bytes = 0;
  for (const FiberFrame& frame : section.frames)
    bytes += 2 * static_cast<double>(frame.points.size()) + 16 * static_cast<double>(frame.birth.size());
  return bytes;
}

bool tells(const FibersSection& section, const std::string& words) {
  return section.caption.find(words) != std::string::npos;
}

TEST(CellSection, ShowsASmallResultWhole) {
  const Frames frames(5);
  const FibersSection section = fibers_section(frames.open(), "Flow along x.");
  EXPECT_EQ(section.frames.size(), 5U);
  EXPECT_EQ(section.encoding, NodeEncoding::exact);
  EXPECT_EQ(section.caption, "Flow along x.");
  ASSERT_TRUE(section.breaks.has_value());
  EXPECT_TRUE(section.breaks->empty());
}

TEST(CellSection, LeavesFramesOutFirst) {
  const Frames frames(100);
  const double one_frame = 6.0 * fibers * nodes + 16.0 * fibers;
  const PageRoom room{1000, 60 * one_frame};
  const FibersSection section = fibers_section(frames.open(), "", {}, room);
  EXPECT_EQ(section.frames.size(), 60U);
  EXPECT_EQ(section.frames.front().time_s, 0);
  EXPECT_DOUBLE_EQ(section.frames.back().time_s, 0.099);
  EXPECT_EQ(section.encoding, NodeEncoding::grid);
  EXPECT_TRUE(tells(section, "60 of 100 frames and all fibers"));
  EXPECT_TRUE(tells(section, "result.vtkhdf beside this page has everything in full"));
}

TEST(CellSection, LeavesFibersOutWhereFramesAreFew) {
  const Frames frames(100);
  const double one_frame = 6.0 * fibers * nodes + 16.0 * fibers;
  const PageRoom room{1000, 16 * one_frame};
  CellHistory history;
  history.breaks = {{0.01, 3, 2}, {0.02, 4, 2}};
  const FibersSection section = fibers_section(frames.open(), "", history, room);
  // Every third of the fibers leaves room for 48 frames; fewer than 40 do not show a motion.
  EXPECT_EQ(section.frames.size(), 48U);
  EXPECT_EQ(section.frames.front().birth, (std::vector<std::int32_t>{0, 3, 6, 9, 12, 15, 18, 21, 24, 27}));
  EXPECT_LE(bytes_of(section), room.encoded_bytes);
  EXPECT_GE(bytes_of(section), 0.9 * room.encoded_bytes);
  EXPECT_TRUE(tells(section, "48 of 100 frames and one fiber of 3"));
  ASSERT_EQ(section.breaks->size(), 1U);
  EXPECT_EQ(section.breaks->front().birth, 3);
}

}  // namespace
}  // namespace fiberfate
