// What studies choose about a run.
#include "studies/run_choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fiberfate {
namespace {

constexpr double default_rows = 200;
constexpr double most_rows = 1e6;  ///< more are a slip of the unit

}  // namespace

KeyRow<RunChoices> duration_key(double longest, const char* example) {
  return key("duration", &RunChoices::duration, {"s"}, Range::positive(longest), "Simulated time.",
             required(example));
}

KeyRow<RunChoices> seed_key() {
  return key("seed", &RunChoices::seed, {}, Range::not_negative(),
             "Seed of all random numbers: the same seed gives the same result on any number of threads.");
}

KeyRow<RunChoices> threads_key() {
  return key("threads", &RunChoices::threads, {}, Range::between(0, 4096),
             "Threads; 0 for as many as the machine has.");
}

KeyRow<SeriesChoices> interval_key() {
  return key("interval", &SeriesChoices::interval, {"s"}, Range::positive(),
             "Time between rows of series.csv; not given: a 200th of the duration.");
}

void validate_series(const RunChoices& run, const SeriesChoices& series, CaseChecker& checker) {
  if (!series.interval || run.duration / *series.interval <= most_rows) return;
  checker.error("output.interval", fmt::format("makes {:.3g} rows", run.duration / *series.interval),
                fmt::format("give at least {:.3g} s", run.duration / most_rows));
}

std::vector<double> series_times(const RunChoices& run, const SeriesChoices& series,
                                 std::vector<double> others) {
  const double interval = series.interval.value_or(run.duration / default_rows);
  std::vector<double> times = std::move(others);
  const double count = std::floor(run.duration / interval * (1 + 1e-12));
  for (double i = 0; i <= count; ++i) times.push_back(std::min(i * interval, run.duration));
  times.push_back(run.duration);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end(),
                          [interval](double a, double b) { return b - a < 1e-9 * interval; }),
              times.end());
  return times;
}

}  // namespace fiberfate
