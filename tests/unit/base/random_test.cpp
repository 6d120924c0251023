// Tests that random numbers are a pure function of their counter and follow their laws.
#include "base/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace fiberfate {
namespace {

TEST(Random, IsAFunctionOfSeedStreamAndCounter) {
  const double value = uniform(1, RandomStream::breakage, {2, 3, 4});
  EXPECT_EQ(value, uniform(1, RandomStream::breakage, {2, 3, 4}));
  EXPECT_NE(value, uniform(2, RandomStream::breakage, {2, 3, 4}));
  EXPECT_NE(value, uniform(1, RandomStream::position, {2, 3, 4}));
  EXPECT_NE(value, uniform(1, RandomStream::breakage, {3, 3, 4}));
  EXPECT_NE(value, uniform(1, RandomStream::breakage, {2, 4, 4}));
  EXPECT_NE(value, uniform(1, RandomStream::breakage, {2, 3, 5}));
}

/// Turns four 32-bit words into the numbers that uniform4 makes of them, the midpoints of 2³² equal
/// intervals.
std::array<double, 4> midpoints(std::array<std::uint32_t, 4> words) {
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) numbers[i] = (words[i] + 0.5) / 4294967296.0;
  return numbers;
}

// Known answers of Philox4x32-10, from the reference implementation's own test (Random123, kat_vectors).
TEST(Random, IsPhilox) {
  EXPECT_EQ(uniform4(0, RandomStream(0), {0, 0, 0}),
            midpoints({0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(uniform4(0xffffffffffffffff, RandomStream(0xffffffff), {0xffffffff, 0xffffffff, 0xffffffff}),
            midpoints({0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(uniform4(0x299f31d0a4093822, RandomStream(0x03707344), {0x243f6a88, 0x85a308d3, 0x13198a2e}),
            midpoints({0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, UniformHasTheMomentsOfTheUnitInterval) {
  constexpr std::uint32_t draws = 20000;
  double sum = 0;
  double squares = 0;
  for (std::uint32_t i = 0; i < draws; ++i) {
    for (const double u : uniform4(7, RandomStream::noise, {i, 0, 0})) {
      ASSERT_GT(u, 0.0);
      ASSERT_LT(u, 1.0);
      sum += u;
      squares += u * u;
    }
  }
  // Four standard errors: sqrt(1/12/80000) = 1.0e-3 and sqrt(4/45/80000) = 1.05e-3.
  EXPECT_NEAR(sum / (4 * draws), 0.5, 4.1e-3);
  EXPECT_NEAR(squares / (4 * draws), 1.0 / 3, 4.2e-3);
}

TEST(Random, NormalHasZeroMeanAndUnitVariance) {
  constexpr std::uint32_t draws = 40000;
  double sum = 0;
  double squares = 0;
  for (std::uint32_t i = 0; i < draws; ++i) {
    for (const double z : normal2(7, RandomStream::noise, {i, 1, 0})) {
      sum += z;
      squares += z * z;
    }
  }
  // Four standard errors: sqrt(1/80000) = 3.5e-3 and sqrt(2/80000) = 5e-3.
  EXPECT_NEAR(sum / (2 * draws), 0.0, 1.4e-2);
  EXPECT_NEAR(squares / (2 * draws), 1.0, 2.0e-2);
}

}  // namespace
}  // namespace fiberfate
