// Tests that what there is of memory is known, and that more is refused.
#include "base/memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <new>

#include "base/error.hpp"

namespace fiberfate {
namespace {

TEST(FreeMemory, IsMoreThanATestTakesAndLessThanAnyMachineHas) {
  EXPECT_GT(free_memory_bytes(), 1e6);
  EXPECT_LT(free_memory_bytes(), 1e15);
}

TEST(FreeMemory, HeedsTheLimitOfTheProcess) {
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  const double more = 64e6;
  rlimit less = before;
  less.rlim_cur = static_cast<rlim_t>(static_cast<double>(held_address_space()) + more);
  ASSERT_EQ(setrlimit(RLIMIT_AS, &less), 0);
  const double free = free_memory_bytes();
  setrlimit(RLIMIT_AS, &before);
  EXPECT_LE(free, more);
  EXPECT_GT(free, 0.5 * more);
}

TEST(RequireRoom, TellsWhatALibraryCouldNotHave) {
  EXPECT_NO_THROW(require_room(1 << 20));
  EXPECT_THROW(require_room(std::size_t{1} << 60), std::bad_alloc);
}

TEST(RequireMemory, RefusesInWords) {
  EXPECT_NO_THROW(require_memory(1e3, "take less"));
  try {
    require_memory(1e18, "take fewer bins");
    FAIL() << "an exabyte was granted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("this takes about 1000000000.0 GB of memory, and about "), std::string::npos) << text;
    EXPECT_NE(text.find("take fewer bins"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace fiberfate
