// Tests what a summary says of files that are none.
#include "results/summary.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"

namespace fiberfate {
namespace {

TEST(SummaryFile, RefusesTextsAndNumbersThatItCannotHold) {
  const std::string path = std::filesystem::temp_directory_path() / "fiberfate_summary_test.json";
  for (const char* text : {"", "{", "[1]", "{\"breaks\": 1e999}"}) {
    std::ofstream(path) << text;
    EXPECT_THROW(SummaryFile{path}, StorageError) << text;
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace fiberfate
