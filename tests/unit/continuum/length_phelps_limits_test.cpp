// Tests that bins and flows beyond what can be computed are refused before memory or time is spent.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "continuum/phelps_solver.hpp"

namespace fiberfate {
namespace {

const PhelpsConstants constants = {0.02, 3, 0.25, 73e9, 19e-6, 0, PhelpsBreakage::share};

TEST(PhelpsLimits, TooManyBinsAreRefusedWithTheMemoryThatTheyWouldTake) {
  try {
    PhelpsSolver(constants, {100000, 15e-3});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("40 GB"), std::string::npos) << error.what();
  }
  EXPECT_THROW(PhelpsSolver(constants, {std::size_t{1} << 32, 15e-3}), InputError);
  EXPECT_THROW(PhelpsSolver(constants, {~std::size_t{0}, 15e-3}), InputError);
  EXPECT_THROW(static_cast<void>(child_numbers(std::size_t{1} << 32, 0.25)), InputError);
  EXPECT_THROW(static_cast<void>(sort_into_bins({{1e-3}, {1}}, {std::size_t{1} << 40, 15e-3})), InputError);
}

TEST(PhelpsLimits, TheEstimateIsWhatThePackedChildrenTake) {
  // Half of bins² numbers, within the rows that complete four.
  EXPECT_NEAR(PhelpsSolver::memory_bytes(1000), 8 * 0.5e6, 0.02 * 4e6);
  EXPECT_NEAR(PhelpsSolver::memory_bytes(100000), 40e9, 0.01 * 40e9);
  EXPECT_GT(PhelpsSolver::scratch_bytes(1000), 5 * 8 * 8 * 1000.0);
}

TEST(PhelpsLimits, EndlessFlowsEndOrAreRefusedInWords) {
  const PhelpsSolver solver(constants, {50, 15e-3});
  std::vector<double> numbers(50, 1.0);
  EXPECT_THROW(solver.advance({INFINITY, 100, 1}, 1, numbers), InputError);
  EXPECT_THROW(solver.advance({1e300, 100, 1}, 1, numbers), SimulationFailure);
  EXPECT_EQ(numbers, std::vector<double>(50, 1.0));
  // Two million breakages of the longest fiber: soon nothing is left that could break.
  EXPECT_NO_THROW(solver.advance({1e5, 1000, 1}, 1000, numbers));
  double length = 0;
  for (std::size_t bin = 0; bin < 50; ++bin) length += numbers[bin] * static_cast<double>(bin + 1);
  EXPECT_NEAR(length, 51 * 25, 1e-8);
}

}  // namespace
}  // namespace fiberfate
