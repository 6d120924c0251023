// Makes calibrations of laws to noisy measurements of themselves, and counts how often an interval holds the
// truth.
#pragma once

#include <string>
#include <vector>

#include "calibration/fit_problem.hpp"

namespace fiberfate {

/// A parameter that is sought, or kept, and its true value.
struct TrueParameter {
  std::string name;
  double value;
};

/// A law, what is sought of it, and how well its measurements are known.
struct SyntheticCase {
  enum class Kind { attrition, orientation } kind;
  std::string law;
  std::vector<TrueParameter> sought;
  std::vector<TrueParameter> kept;  ///< parameters without a standard value
  double noise;                     ///< relative of lengths, absolute of components of A2
};

/// Lists every attrition law and every named orientation law of the registries.
const std::vector<SyntheticCase>& synthetic_cases();

/// Poses the calibration to measurements with the noise of this repetition.
FitProblem pose(const SyntheticCase& one, std::uint64_t seed, std::uint32_t repetition);

/// Counts what became of repetitions, for every parameter that is sought.
struct Coverage {
  std::vector<int> held;      ///< repetitions whose 95 % interval held the truth
  int undetermined = 0;       ///< repetitions that left a parameter undetermined or at a bound
  std::uint32_t repetitions;  ///< all
};
Coverage count_held(const SyntheticCase& one, std::uint64_t seed, std::uint32_t repetitions);

}  // namespace fiberfate
