// How far the shearing of a cell is, in words.
#pragma once

#include <string>

namespace fiberfate {

/// How far a run is.
struct RunStatus {
  double time = 0;              ///< simulated, s
  double begin = 0;             ///< simulated time at which this process began, s
  double end = 0;               ///< simulated time at which it will end, s
  double wall = 0;              ///< since this process began to step, s
  double number_average = 0;    ///< L_N, m
  double weight_average = 0;    ///< L_W, m
  double step_size = 0;         ///< s
  const char* step_limit = "";  ///< what holds it down
};

/// Formats a status: "0.0123 of 1.5 s, 0.031 s/min, 47 min left, L_N 2.31 mm, L_W 2.42 mm, step 1.2e-04 s
/// (strain)".
[[nodiscard]] std::string describe(const RunStatus& status);

}  // namespace fiberfate
