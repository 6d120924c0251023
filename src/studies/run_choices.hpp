// What studies choose about a run: how long, with which random numbers, on how many threads, and when rows of
// series.csv are due.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "keys/case_checker.hpp"
#include "keys/key_rows.hpp"

namespace fiberfate {

/// [run]; a study describes those of its keys that it acts on.
struct RunChoices {
  double duration = 0;  ///< simulated time, s
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all that the machine has
};

[[nodiscard]] KeyRow<RunChoices> duration_key(double longest, const char* example);
[[nodiscard]] KeyRow<RunChoices> seed_key();
[[nodiscard]] KeyRow<RunChoices> threads_key();

/// [output] of a study whose rows of series.csv come at even times.
struct SeriesChoices {
  std::optional<double> interval;  ///< s; not given: a 200th of the duration
};

[[nodiscard]] KeyRow<SeriesChoices> interval_key();
/// Finds an interval that makes too many rows.
void validate_series(const RunChoices& run, const SeriesChoices& series, CaseChecker& checker);
/// Lists the times of series.csv, rising, s: multiples of the interval, the end, and the others that are
/// asked for.
[[nodiscard]] std::vector<double> series_times(const RunChoices& run, const SeriesChoices& series,
                                               std::vector<double> others = {});

}  // namespace fiberfate
