// Writes and reads summary.json, whose keys users' scripts rely on.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/timer.hpp"
#include "base/vector.hpp"
#include "fibers/state.hpp"
#include "results/run_types.hpp"

namespace fiberfate {

/// One value of a study's own; an infinite or undefined number is written as null.
using SummaryValue = std::variant<double, std::int64_t, std::string, Mat3, std::vector<double>>;

/// Holds the last values and the timings of a run (docs/formats/summary.md).
struct RunSummary {
  std::string study;
  StopReason stop_reason = StopReason::done;
  std::uint64_t seed = 1;
  int threads = 1;
  double simulated_s = 0;
  std::int64_t steps = 0;
  double wall_s = 0;
  double cpu_s = 0;
  std::int64_t rods = 0;
  std::int64_t fibers = 0;
  double segment_steps_per_s = 0;
  double number_average = 0;  ///< L_N, m
  double weight_average = 0;  ///< L_W, m
  Mat3 orientation = Mat3::Zero();
  std::int64_t breaks = 0;
  double volume_fraction = 0;
  double max_overlap = 0;  ///< radii
  PhaseTimes timings;
  std::vector<std::pair<std::string, SummaryValue>> own;  ///< keys of the study's own
};

/// Fills in what follows from the fibers: time, steps, counts, lengths, orientation, breaks, volume fraction;
/// and the number of threads.
void describe_fibers(RunSummary& summary, const FiberState& state);

/// Writes the file in one step; raises StorageError.
void write_summary(const std::string& path, const RunSummary& summary);

/// Gives the values of a summary file.
class SummaryFile {
 public:
  /// Raises StorageError when the file is missing or not JSON.
  explicit SummaryFile(const std::string& path);
  ~SummaryFile();
  [[nodiscard]] double number(const std::string& key) const;       ///< NaN where it is missing or null
  [[nodiscard]] std::int64_t count(const std::string& key) const;  ///< 0 where it is missing
  [[nodiscard]] std::string text(const std::string& key) const;    ///< empty where it is missing
  [[nodiscard]] Mat3 tensor(const std::string& key) const;         ///< NaN where it is missing
  [[nodiscard]] std::vector<double> numbers(const std::string& key) const;  ///< empty where they are missing
  /// Lists the seconds of each phase in the order of phase_names.
  [[nodiscard]] std::vector<double> timings() const;

 private:
  struct Document;
  std::unique_ptr<Document> document_;
};

}  // namespace fiberfate
