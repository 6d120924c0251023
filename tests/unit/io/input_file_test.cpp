// Tests what is no file to read: pipes, devices, folders, links that lead back, what is too large.
#include "io/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/hdf5_file.hpp"
#include "unit/io/scratch_folder.hpp"

namespace fiberfate {
namespace {

TEST(InputFile, ReadsFiles) {
  const ScratchFolder folder;
  replace_file(folder / "a.txt", "text");
  EXPECT_EQ(read_input_file(folder / "a.txt"), "text");
}

TEST(InputFile, TellsWhatCannotBeRead) {
  const ScratchFolder folder;
  EXPECT_EQ(reading_fault(folder / "none"), "cannot be read (No such file or directory)");
  EXPECT_EQ(reading_fault(folder / ""), "is a folder, not a file");
  EXPECT_EQ(reading_fault("/dev/zero"), "is a pipe or a device, not a file");
  EXPECT_EQ(reading_fault(folder / std::string(300, 'x')), "cannot be read (File name too long)");
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_EQ(reading_fault(folder / "loop"), "cannot be read (Too many levels of symbolic links)");
  replace_file(folder / "large", std::string(3000, 'x'));
  EXPECT_EQ(reading_fault(folder / "large", 2999), "is larger than 0 MB");
  EXPECT_EQ(reading_fault(folder / "large", 3000), "");
  EXPECT_THROW(static_cast<void>(read_input_file("/dev/zero")), InputError);
}

TEST(InputFile, DoesNotWaitForPipes) {
  const ScratchFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(reading_fault(folder / "pipe"), "is a pipe or a device, not a file");
  EXPECT_THROW(static_cast<void>(read_file(folder / "pipe")), StorageError);
  EXPECT_THROW(static_cast<void>(Hdf5File::open(folder / "pipe", Hdf5File::Access::read)), StorageError);
}

}  // namespace
}  // namespace fiberfate
