// Tests that tables keep every bit and continue where they were.
#include "io/csv_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "unit/io/scratch_folder.hpp"

namespace fiberfate {
namespace {

TEST(CsvTable, KeepsEveryBit) {
  const ScratchFolder folder;
  const std::vector<double> values = {1.0 / 3, 5e-324, -1e300, 628, std::numeric_limits<double>::infinity()};
  CsvWriter writer(folder / "t.csv", {"time_s", "x_m"}, 0);
  for (const double value : values) writer.append(std::array{value, 2.0});
  writer.flush();
  EXPECT_EQ(read_csv(folder / "t.csv").column("time_s"), values);
  EXPECT_EQ(read_file(folder / "t.csv").substr(0, 30), "time_s,x_m\n0.3333333333333333,");
}

TEST(CsvTable, ContinuesAfterTheRowsThatCount) {
  const ScratchFolder folder;
  {
    CsvWriter writer(folder / "t.csv", {"a", "b"}, 0);
    for (int i = 0; i < 5; ++i) writer.append(std::array{1.0 * i, 10.0 * i});
  }
  CsvWriter writer(folder / "t.csv", {"a", "b"}, 3);
  EXPECT_EQ(writer.rows(), 3);
  writer.append(std::array{7.0, 8.0});
  writer.sync();
  EXPECT_EQ(read_csv(folder / "t.csv").column("a"), (std::vector<double>{0, 1, 2, 7}));
}

TEST(CsvTable, RefusesToContinueAnotherTable) {
  const ScratchFolder folder;
  CsvWriter(folder / "t.csv", {"a", "b"}, 0).append(std::array{1.0, 2.0});
  EXPECT_THROW(CsvWriter(folder / "t.csv", {"a", "c"}, 1), StorageError);
  EXPECT_THROW(CsvWriter(folder / "t.csv", {"a", "b"}, 2), StorageError);
}

TEST(CsvTable, NamesTheLineAtFault) {
  const ScratchFolder folder;
  replace_file(folder / "t.csv", "# remark\na,b\n1,2\n3,x\n");
  try {
    static_cast<void>(read_csv(folder / "t.csv"));
    FAIL() << "a word was read as a number";
  } catch (const StorageError& error) {
    EXPECT_EQ(std::string(error.what()), (folder / "t.csv") + ":4: 'x' is not a number");
  }
  replace_file(folder / "t.csv", "a,b\n1\n");
  EXPECT_THROW(static_cast<void>(read_csv(folder / "t.csv")), StorageError);
}

TEST(CsvTable, LeavesOutARowThatIsHalfWritten) {
  const ScratchFolder folder;
  replace_file(folder / "t.csv", "a,b\n1,2\n3");
  EXPECT_EQ(read_csv(folder / "t.csv").column("a"), (std::vector<double>{1}));
}

TEST(CsvTable, IsWrittenWholeToo) {
  const ScratchFolder folder;
  write_csv(folder / "t.csv", {{"a", "b"}, {{1, 2}, {3, 4.5}}});
  EXPECT_EQ(read_file(folder / "t.csv"), "a,b\n1,3\n2,4.5\n");
}

}  // namespace
}  // namespace fiberfate
