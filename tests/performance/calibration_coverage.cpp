// Counts for every law how often the 95 % interval of a calibration holds the truth: calibration_coverage
// [REPETITIONS [SEED]].
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "physics/process/synthetic_calibration.hpp"

int main(int count, char** words) {
  using namespace fiberfate;
  const auto repetitions = static_cast<std::uint32_t>(count > 1 ? std::atoi(words[1]) : 100);
  const auto seed = static_cast<std::uint64_t>(count > 2 ? std::atoi(words[2]) : 1);
  bool all_within = true;
  fmt::print("law                  parameter   held of {}    %\n", repetitions);
  for (const SyntheticCase& one : synthetic_cases()) {
    if (count > 3 && one.law != words[3]) continue;
    const Coverage coverage = count_held(one, seed, repetitions);
    for (std::size_t k = 0; k < coverage.held.size(); ++k) {
      const double percent = 100.0 * coverage.held[k] / repetitions;
      const bool within = std::abs(percent - 95) <= 4;
      all_within = all_within && within;
      fmt::print("{:<20} {:<10} {:>10} {:>8.1f}{}\n", one.law, one.sought[k].name, coverage.held[k], percent,
                 within ? "" : "  outside of 95 +- 4");
    }
    if (coverage.undetermined > 0)
      fmt::print("{:<20} left undetermined {} times\n", one.law, coverage.undetermined);
    std::fflush(stdout);
  }
  return all_within ? EXIT_SUCCESS : EXIT_FAILURE;
}
