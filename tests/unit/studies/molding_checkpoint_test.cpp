// Tests that a checkpoint of a filling gives back every bit, and that one whose parts do not fit is refused
// as damaged.
#include "studies/molding/checkpoint.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <functional>

#include "base/error.hpp"
#include "physics/molding/full_filling.hpp"
#include "physics/molding/same_state.hpp"

namespace fiberfate {
namespace {

class MoldingCheckpointTest : public testing::Test {
 protected:
  ~MoldingCheckpointTest() override { std::filesystem::remove_all(path_); }

  /// A filling with everything on, under way.
  static const MoldingCheckpoint& sample() {
    static const MoldingCheckpoint checkpoint = [] {
      Filling filling(ShellMesh(test::plaque()), test::full_params());
      while (filling.filled_fraction() < 0.6) filling.advance();
      return MoldingCheckpoint{filling.mesh().shell(), filling.state(), {21, 4, 5.5, 6.25, 1.0 / 3}};
    }();
    return checkpoint;
  }
  /// What is said about the checkpoint once it is changed.
  std::string complaint(const std::function<void(MoldingCheckpoint&)>& change) {
    MoldingCheckpoint changed = sample();
    change(changed);
    write_molding(path_, changed);
    try {
      (void)read_molding(path_);
    } catch (const StorageError& error) {
      return error.what();
    }
    return "";
  }

  std::string path_ = (std::filesystem::temp_directory_path() /
                       ("fiberfate_molding_checkpoint_" + std::to_string(::getpid()) + ".h5"))
                          .string();
};

TEST_F(MoldingCheckpointTest, GivesBackEveryBit) {
  write_molding(path_, sample());
  const MoldingCheckpoint after = read_molding(path_);
  test::expect_same(after.state, sample().state);
  EXPECT_EQ(after.shell.triangles, sample().shell.triangles);
  EXPECT_EQ(after.shell.thickness, sample().shell.thickness);
  EXPECT_EQ(after.shell.region, sample().shell.region);
  EXPECT_EQ(after.shell.junctions, sample().shell.junctions);
  for (std::size_t i = 0; i < after.shell.nodes.size(); ++i)
    EXPECT_EQ(after.shell.nodes[i], sample().shell.nodes[i]);
  EXPECT_EQ(after.record.series_rows, 21);
  EXPECT_EQ(after.record.frames, 4);
  EXPECT_EQ(after.record.wall_s, 5.5);
  EXPECT_EQ(after.record.cpu_s, 6.25);
  EXPECT_EQ(after.record.greatest_pressure, 1.0 / 3);
}

/// Checksums see bits that have flipped, not parts of two states in one file.
TEST_F(MoldingCheckpointTest, RefusesPartsThatDoNotFit) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<std::function<void(MoldingCheckpoint&)>, const char*> faults[] = {
      {[](auto& c) { c.state.filled.pop_back(); }, "dataset state/filled: 285 values where 286 belong"},
      {[](auto& c) { c.state.filled[3] = 1.5; }, "dataset state/filled: value 3 is 1.5"},
      {[&](auto& c) { c.state.pressure[2] = nan; }, "dataset state/pressure: value 2 is nan"},
      {[](auto& c) { c.state.temperature[9] = -1; }, "dataset state/temperature: value 9 is -1"},
      {[](auto& c) { c.state.lengths.pop_back(); }, "dataset state/lengths"},
      {[](auto& c) { c.state.orientation[5].pop_back(); }, "dataset state/orientation_5"},
      {[](auto& c) { c.state.inflow.pop_back(); }, "dataset state/inflow"},
      {[](auto& c) { c.state.mark[0] = static_cast<NodeMark>(9); }, "dataset state/mark"},
      {[](auto& c) { c.state.gates[1].moves = -3; }, "dataset state/gates: gate 1 cannot have moved"},
      {[&](auto& c) { c.state.gates[0].volume = nan; }, "numbers of gate 0 are not finite"},
      {[](auto& c) { c.state.events[0].gate = 7; }, "dataset state/events"},
      {[](auto& c) { c.state.time = -1; }, "dataset state/time: -1 is negative"},
      {[](auto& c) { c.state.stop_reason = static_cast<FillingEnd>(40); }, "dataset state/end"},
      {[](auto& c) { c.state.control = static_cast<ControlMode>(-2); }, "dataset state/control"},
      {[](auto& c) { c.record.series_rows = -1; }, "dataset state/series_rows: -1 is negative"},
      {[](auto& c) { c.record.frames = -1; }, "dataset state/frames: -1 is negative"},
      {[&](auto& c) { c.record.greatest_pressure = nan; }, "dataset state/greatest_pressure: nan"},
      {[](auto& c) { c.shell.thickness[0] = 0; }, "dataset shell: triangle 0"},
      {[](auto& c) { c.shell.triangles[1][2] = 5000; }, "dataset shell: triangle 1 names node 5000 of 286"},
      {[](auto& c) { c.shell.triangles.clear(); }, "dataset shell: the shell has no triangles"},
  };
  for (const auto& [change, words] : faults) {
    const std::string told = complaint(change);
    EXPECT_NE(told.find(words), std::string::npos) << words << "\n" << told;
    EXPECT_NE(told.find(path_ + " does not hold together"), std::string::npos) << told;
  }
  EXPECT_EQ(complaint([](auto&) {}), "");
}

TEST_F(MoldingCheckpointTest, IsOfOneCase) {
  EXPECT_NO_THROW((void)filling_from(sample(), test::full_params()));
  FillingParams finer = test::full_params(), gateless = finer;
  finer.numerics.layers = 12;
  gateless.gates.pop_back();
  EXPECT_THROW((void)filling_from(sample(), finer), StorageError);
  EXPECT_THROW((void)filling_from(sample(), gateless), StorageError);
}

}  // namespace
}  // namespace fiberfate
