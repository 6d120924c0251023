// What studies choose about a run: how long, with which random numbers, on how many threads, and when rows of
// series.csv are due.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
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
/// The same of a study in which something else may say how long.
[[nodiscard]] KeyRow<RunChoices> duration_key(double longest, const char* text, Given given);
[[nodiscard]] KeyRow<RunChoices> seed_key();
[[nodiscard]] KeyRow<RunChoices> threads_key();

/// [output] of a study whose rows of series.csv come at times of its choice.
struct SeriesChoices {
  std::optional<double> interval;  ///< s; not given: 1/200 of the duration, or only `times` where it has some
  std::vector<double> times;       ///< s
};

/// The keys `interval` and `times`.
[[nodiscard]] KeyRows<SeriesChoices> series_rows();
/// Finds an interval that makes too many rows, and times after the end.
void validate_series(const RunChoices& run, const SeriesChoices& series, CaseChecker& checker);
/// Finds a time of a key that comes after the end of the run.
void validate_times(const std::string& key, std::span<const double> times, const RunChoices& run,
                    CaseChecker& checker);
/// The time between rows that come at even times, s; the duration where rows come at chosen times only.
[[nodiscard]] double series_interval(const RunChoices& run, const SeriesChoices& series);
/// Lists the times of series.csv, rising, s: multiples of the interval, those chosen, the end, and the others
/// that are asked for.
[[nodiscard]] std::vector<double> series_times(const RunChoices& run, const SeriesChoices& series,
                                               std::vector<double> others = {});

}  // namespace fiberfate
