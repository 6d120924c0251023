// Tests that files are replaced whole or not at all.
#include "io/atomic_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "unit/io/scratch_folder.hpp"

namespace fiberfate {
namespace {

TEST(ReplaceFile, WritesAndReplaces) {
  const ScratchFolder folder;
  replace_file(folder / "a", "one");
  replace_file(folder / "a", "three");
  EXPECT_EQ(read_file(folder / "a"), "three");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.new"));
}

TEST(ReplaceFile, NamesThePathAndTheReason) {
  const ScratchFolder folder;
  const std::string path = folder / "missing/a";
  try {
    replace_file(path, "one");
    FAIL() << "a file was written into a folder that does not exist";
  } catch (const StorageError& error) {
    EXPECT_EQ(std::string(error.what()), "cannot create " + path + ".new: No such file or directory");
  }
}

TEST(ReadFile, RaisesForAMissingFile) {
  const ScratchFolder folder;
  EXPECT_THROW(static_cast<void>(read_file(folder / "none")), StorageError);
}

TEST(ExchangeFiles, SwapsNames) {
  const ScratchFolder folder;
  replace_file(folder / "a", "A");
  replace_file(folder / "b", "B");
  exchange_files(folder / "a", folder / "b");
  EXPECT_EQ(read_file(folder / "a"), "B");
  EXPECT_EQ(read_file(folder / "b"), "A");
}

TEST(AppendedFile, KeepsTextUntilFlushed) {
  const ScratchFolder folder;
  AppendedFile file(folder / "log");
  file.append("one\n");
  EXPECT_EQ(read_file(folder / "log"), "");
  file.flush();
  file.append("two\n");
  file.sync();
  EXPECT_EQ(read_file(folder / "log"), "one\ntwo\n");
}

TEST(AppendedFile, ReportsAFullDisk) {
  AppendedFile file("/dev/full");
  file.append("more than nothing");
  try {
    file.flush();
    FAIL() << "a full device took bytes";
  } catch (const StorageError& error) {
    EXPECT_STREQ(error.what(),
                 "cannot write /dev/full: the disk is full (No space left on device): make room there; what "
                 "ended early goes on with 'fiberfate resume'");
  }
}

}  // namespace
}  // namespace fiberfate
