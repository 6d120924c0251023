// Tests that HDF5 files give back what was put in, and that damage is noticed and named.
#include "io/hdf5_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "unit/io/scratch_folder.hpp"

namespace fiberfate {
namespace {

using Access = Hdf5File::Access;

template <class T>
std::span<const T> view(const std::vector<T>& values) {
  return {values.data(), values.size()};
}

TEST(Hdf5File, GivesBackEveryElementType) {
  const ScratchFolder folder;
  Hdf5File file = Hdf5File::create(folder / "a.h5");
  const auto there_and_back = [&file](const std::string& name, const auto& values) {
    using T = typename std::decay_t<decltype(values)>::value_type;
    file.write(name, view(values));
    EXPECT_EQ(file.read<T>(name), values) << name;
  };
  there_and_back("group/sub/double", std::vector<double>{1.0 / 3, -2e300, 0});
  there_and_back("float", std::vector<float>{1.5F, -2.5F});
  there_and_back("int64", std::vector<std::int64_t>{-1, std::int64_t{1} << 62});
  there_and_back("int32", std::vector<std::int32_t>{-1, 7});
  there_and_back("uint32", std::vector<std::uint32_t>{4000000000U});
  there_and_back("uint16", std::vector<std::uint16_t>{65535});
  there_and_back("uint8", std::vector<std::uint8_t>{255, 0, 1});
  there_and_back("empty", std::vector<double>{});
  EXPECT_TRUE(file.contains("group/sub/double"));
  EXPECT_FALSE(file.contains("group/none/double"));
}

TEST(Hdf5File, GivesBackTextsAndAttributes) {
  const ScratchFolder folder;
  Hdf5File file = Hdf5File::create(folder / "a.h5");
  const std::string text = "µm\n[fibers]\nlength = 1e-3\n";
  file.write_text("case", text);
  EXPECT_EQ(file.read_text("case"), text);
  file.write_text_attribute("case", "unit", "m");
  EXPECT_EQ(file.read_text_attribute("case", "unit"), "m");
  file.write_attribute("/", "steps", std::int64_t{3});
  file.write_attribute("/", "steps", std::int64_t{4});
  EXPECT_EQ(file.read_attribute<std::int64_t>("/", "steps"), 4);
}

TEST(Hdf5File, LengthensTables) {
  const ScratchFolder folder;
  {
    Hdf5File file = Hdf5File::create(folder / "a.h5");
    file.make_table("t/points", {Element::float64, 3, 4, TableLayout::Compression::none});
    file.make_table("t/ids", {Element::int64, 0, 4, TableLayout::Compression::deflate});
    file.append("t/points", view(std::vector<double>{1, 2, 3, 4, 5, 6}));
    file.append("t/ids", view(std::vector<std::int64_t>{1, 2, 3, 4, 5}));
    file.close();
  }
  Hdf5File file = Hdf5File::open(folder / "a.h5", Access::read_write);
  file.append("t/points", view(std::vector<double>{7, 8, 9}));
  EXPECT_EQ(file.rows("t/points"), 3U);
  EXPECT_EQ(file.columns("t/points"), 3U);
  EXPECT_EQ(file.read_rows<double>("t/points", {1, 2}), (std::vector<double>{4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(file.read<std::int64_t>("t/ids"), (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(file.members("t"), (std::vector<std::string>{"ids", "points"}));
  EXPECT_EQ(file.layout("t/points").columns, 3);
  EXPECT_EQ(file.layout("t/ids").compression, TableLayout::Compression::deflate);
}

TEST(Hdf5File, RaisesForATruncatedFile) {
  const ScratchFolder folder;
  Hdf5File file = Hdf5File::create(folder / "a.h5");
  file.write("x", view(std::vector<double>(1000, 1.5)));
  file.close();
  std::filesystem::resize_file(folder / "a.h5", std::filesystem::file_size(folder / "a.h5") / 2);
  try {
    static_cast<void>(Hdf5File::open(folder / "a.h5", Access::read));
    FAIL() << "a truncated file was opened";
  } catch (const StorageError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot open " + (folder / "a.h5") + ": "), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("truncated file"), std::string::npos) << error.what();
  }
}

TEST(Hdf5File, RaisesForAFlippedBit) {
  const ScratchFolder folder;
  Hdf5File file = Hdf5File::create(folder / "a.h5");
  file.write("x", view(std::vector<double>(1000, 1.5)));
  file.close();
  std::string bytes = read_file(folder / "a.h5");
  const double value = 1.5;
  const std::string pattern(reinterpret_cast<const char*>(&value), sizeof value);
  const std::size_t place = bytes.find(pattern + pattern);
  ASSERT_NE(place, std::string::npos);
  bytes[place + 80] = static_cast<char>(bytes[place + 80] ^ 4);
  replace_file(folder / "a.h5", std::string_view(bytes));
  const Hdf5File damaged = Hdf5File::open(folder / "a.h5", Access::read);
  EXPECT_THROW(static_cast<void>(damaged.read<double>("x")), StorageError);
}

TEST(Hdf5File, AsksForNoMoreMemoryThanTheFileIsWorth) {
  const ScratchFolder folder;
  Hdf5File file = Hdf5File::create(folder / "a.h5");
  file.make_table("x", {Element::float64, 0, 64});
  constexpr std::uint64_t marked = 0x1234;
  file.append("x", view(std::vector<double>(marked, 1.5)));
  file.close();
  std::string bytes = read_file(folder / "a.h5");
  // The head of a dataset has its rows, and then the most that they may become.
  const std::string rows =
      std::string(reinterpret_cast<const char*>(&marked), sizeof marked) + std::string(8, '\xff');
  const std::size_t place = bytes.find(rows);
  ASSERT_NE(place, std::string::npos);
  bytes[place + 5] = 0x40;  // 7e13 rows
  // A dataset is guarded by a checksum of its head, which a reader may find wrong first.
  replace_file(folder / "a.h5", std::string_view(bytes));
  const Hdf5File damaged = Hdf5File::open(folder / "a.h5", Access::read);
  EXPECT_THROW(static_cast<void>(damaged.read<double>("x")), StorageError);
}

TEST(Hdf5File, NamesTheDatasetThatIsMissing) {
  const ScratchFolder folder;
  const Hdf5File file = Hdf5File::create(folder / "a.h5");
  try {
    static_cast<void>(file.read<double>("group/none"));
    FAIL() << "a dataset was read that does not exist";
  } catch (const StorageError& error) {
    EXPECT_NE(std::string(error.what()).find("cannot read " + (folder / "a.h5") + " (group/none): "),
              std::string::npos)
        << error.what();
  }
}

TEST(Hdf5File, RaisesForAFileThatIsNoHdf5) {
  const ScratchFolder folder;
  replace_file(folder / "a.h5", "not HDF5 at all");
  EXPECT_THROW(static_cast<void>(Hdf5File::open(folder / "a.h5", Access::read)), StorageError);
  EXPECT_THROW(static_cast<void>(Hdf5File::open(folder / "none.h5", Access::read)), StorageError);
}

}  // namespace
}  // namespace fiberfate
