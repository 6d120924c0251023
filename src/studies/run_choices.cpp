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
  return duration_key(longest, "Simulated time.", required(example));
}

KeyRow<RunChoices> duration_key(double longest, const char* text, Given given) {
  return key("duration", &RunChoices::duration, {"s"}, Range::positive(longest), text, given);
}

KeyRow<RunChoices> seed_key() {
  return key("seed", &RunChoices::seed, {}, Range::not_negative(),
             "Seed of all random numbers: the same seed gives the same result on any number of threads.");
}

KeyRow<RunChoices> threads_key() {
  return key("threads", &RunChoices::threads, {}, Range::between(0, 4096),
             "Threads; 0 for as many as the machine has.");
}

KeyRows<SeriesChoices> series_rows() {
  return {key("interval", &SeriesChoices::interval, {"s"}, Range::positive(),
              "Simulated time between rows of series.csv; not given: 1/200 of the duration, or only rows at "
              "output.times.",
              optional("\"0.05 s\"")),
          key("times", &SeriesChoices::times, {"s"}, Range::not_negative(),
              "Simulated times of rows of series.csv, besides the start, the end and those of "
              "output.interval.",
              optional("[\"1 s\", \"5 s\"]"))};
}

void validate_series(const RunChoices& run, const SeriesChoices& series, CaseChecker& checker) {
  if (run.duration <= 0) return;
  validate_times("output.times", series.times, run, checker);
  if (!series.interval || run.duration / *series.interval <= most_rows) return;
  checker.error(
      "output.interval",
      fmt::format("makes {:.3g} rows in {}", run.duration / *series.interval, checker.cite("run.duration")),
      fmt::format("give at least {:.3g} s", run.duration / most_rows));
}

void validate_times(const std::string& key, std::span<const double> times, const RunChoices& run,
                    CaseChecker& checker) {
  const auto late = std::ranges::find_if(times, [&run](double time) { return time > run.duration; });
  if (run.duration > 0 && late != times.end())
    checker.error(key, fmt::format("{:.6g} s comes after the end, {}", *late, checker.cite("run.duration")),
                  "give times up to run.duration");
}

double series_interval(const RunChoices& run, const SeriesChoices& series) {
  return series.interval.value_or(series.times.empty() ? run.duration / default_rows : run.duration);
}

std::vector<double> series_times(const RunChoices& run, const SeriesChoices& series,
                                 std::vector<double> others) {
  const double interval = series_interval(run, series), oneness = 1e-9 * interval;
  // What is chosen counts to the last bit; a multiple of the interval that round-off parts from it is the
  // same.
  std::vector<double> times = std::move(others);
  times.insert(times.end(), series.times.begin(), series.times.end());
  times.push_back(run.duration);
  std::ranges::sort(times);
  const auto chosen = static_cast<std::ptrdiff_t>(times.size());
  const double count = std::floor(run.duration / interval * (1 + 1e-12));
  for (double i = 0; i <= count; ++i) {
    const double time = i * interval;
    const auto end = times.begin() + chosen, next = std::lower_bound(times.begin(), end, time - oneness);
    if (next == end || *next > time + oneness) times.push_back(time);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace fiberfate
