// Tests that a checkpoint gives back every bit of a state.
#include "results/fiber_checkpoint.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>

#include "base/error.hpp"
#include "reference/bitwise_state.hpp"

namespace fiberfate {
namespace {

Checkpoint sample() {
  Checkpoint checkpoint;
  FiberState& state = checkpoint.state;
  state.materials = {{9.5e-6, 73e9, 2550}, {5e-6, 230e9, 1800}};
  state.cell = rectangular_cell(Vec3(1e-3, 2e-3, 3e-3));
  state.cell.lattice(0, 1) = 1.0 / 3;
  state.cell.boundary[1] = Boundary::walls;
  const std::array<Vec3, 4> nodes = {Vec3(0, 0, 0), Vec3(1e-4, 0, 0), Vec3(2e-4, 1e-4, 0),
                                     Vec3(3e-4, 1e-4, 1e-4)};
  append_fiber(state, {nodes, 1});
  append_fiber(state, {nodes, 0});
  split_fibers(state, std::array<NodeIndex, 1>{NodeIndex(2)});
  state.relative_velocity[NodeIndex(3)] = Vec3(1.0 / 7, -2.0 / 7, 5e-300);
  state.time = 0.1 + 0.2;
  state.step_size = 1e-5 / 3;
  state.step = 123456789012;
  state.rod_steps = 987654321098;
  state.breakage_checks = 17;
  RunRecord& record = checkpoint.record;
  record = {11, 12, 13, 14, 15.5, 16.25, {}};
  record.times.add(Phase::solve, 2.5);
  record.times.add(Phase::output, 0.125);
  checkpoint.resolved_case = "study = \"shear_cell\"\n";
  return checkpoint;
}

class CheckpointTest : public testing::Test {
 protected:
  ~CheckpointTest() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_ = [] {
    const auto path =
        std::filesystem::temp_directory_path() / ("fiberfate_checkpoint_" + std::to_string(::getpid()));
    std::filesystem::create_directories(path);
    return path;
  }();
  std::string path_ = (folder_ / "checkpoint.h5").string();
};

TEST_F(CheckpointTest, GivesBackEveryBit) {
  const Checkpoint before = sample();
  write_checkpoint(path_, before);
  const Checkpoint after = read_checkpoint(path_);
  expect_bitwise_equal(before.state, after.state);
  ASSERT_EQ(after.state.materials.size(), 2U);
  EXPECT_EQ(after.state.materials[1].youngs_modulus, 230e9);
  EXPECT_EQ(after.state.materials[1].density, 1800);
  EXPECT_EQ(after.record.series_rows, 11);
  EXPECT_EQ(after.record.break_rows, 12);
  EXPECT_EQ(after.record.frames, 13);
  EXPECT_EQ(after.record.rejections, 14);
  EXPECT_EQ(after.record.wall_s, 15.5);
  EXPECT_EQ(after.record.cpu_s, 16.25);
  EXPECT_EQ(after.record.times.seconds(Phase::solve), 2.5);
  EXPECT_EQ(after.record.times.seconds(Phase::output), 0.125);
  EXPECT_EQ(after.resolved_case, before.resolved_case);
}

TEST_F(CheckpointTest, IsRefusedWhenTruncatedAnywhere) {
  write_checkpoint(path_, sample());
  const auto size = std::filesystem::file_size(path_);
  for (const double share : {0.99, 0.9, 0.5, 0.1, 0.0}) {
    write_checkpoint(path_, sample());
    std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(share * static_cast<double>(size)));
    EXPECT_THROW(static_cast<void>(read_checkpoint(path_)), StorageError) << share;
  }
}

// The second fiber begins at node 3. Loops over nodes would not end.
TEST_F(CheckpointTest, IsRefusedWhereAFiberHasNoRod) {
  for (const int begin : {-1, 0, 1, 9}) {
    Checkpoint damaged = sample();
    damaged.state.first_node[FiberIndex(1)] = NodeIndex(begin);
    write_checkpoint(path_, damaged);
    EXPECT_THROW(static_cast<void>(read_checkpoint(path_)), StorageError) << begin;
  }
}

// Checksums do not see what whole datasets of other content are.
TEST_F(CheckpointTest, IsRefusedWhereNumbersCannotBeThoseOfARun) {
  const std::function<void(Checkpoint&)> damages[] = {
      [](Checkpoint& c) { c.state.cell.lattice.col(2).setZero(); },
      [](Checkpoint& c) { c.state.position[NodeIndex(1)].x() = std::nan(""); },
      [](Checkpoint& c) { c.state.material_id.back() = 7; },
      [](Checkpoint& c) { c.state.time = -1; },
      [](Checkpoint& c) { c.state.step_size = std::nan(""); },
      [](Checkpoint& c) { c.record.series_rows = -3; },
  };
  for (std::size_t which = 0; which < std::size(damages); ++which) {
    Checkpoint damaged = sample();
    damages[which](damaged);
    write_checkpoint(path_, damaged);
    EXPECT_THROW(static_cast<void>(read_checkpoint(path_)), StorageError) << which;
  }
}

}  // namespace
}  // namespace fiberfate
