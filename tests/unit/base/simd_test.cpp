// Checks how the environment chooses the instruction set of the kernels.
#include "base/simd.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "base/error.hpp"

namespace fiberfate {
namespace {

/// Asks for an instruction set in a process of its own, which ends with what is told.
[[noreturn]] void ask_for(const char* wish) {
  ::setenv("FIBERFATE_ISA", wish, 1);
  try {
    std::fputs(name(instruction_set()), stderr);
    ::_exit(0);
  } catch (const InputError& error) {
    std::fputs(error.what(), stderr);
    ::_exit(2);
  }
}

TEST(InstructionSetDeathTest, IsTheOneThatTheEnvironmentNames) {
  EXPECT_EXIT(ask_for("baseline"), testing::ExitedWithCode(0), "baseline");
}

TEST(InstructionSetDeathTest, RefusesAnUnknownName) {
  EXPECT_EXIT(
      ask_for("avx1024"), testing::ExitedWithCode(2),
      "FIBERFATE_ISA = avx1024: there is no such instruction set: give one of baseline, avx2, avx512");
}

}  // namespace
}  // namespace fiberfate
