// Writes and reads summary.json, whose keys users' scripts rely on.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
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

/// The last values and the timings of a run (docs/formats/summary.md); what a study does not have is absent.
struct RunSummary {
  std::string study = {};
  StopReason stop_reason = StopReason::done;
  std::optional<std::uint64_t> seed = {};
  std::optional<double> simulated_s = {};
  std::optional<std::int64_t> steps = {};
  double wall_s = 0;
  double cpu_s = 0;
  std::optional<std::int64_t> rods = {};
  std::optional<std::int64_t> fibers = {};
  std::optional<double> segment_steps_per_s = {};
  std::optional<double> number_average = {};  ///< L_N, m
  std::optional<double> weight_average = {};  ///< L_W, m
  std::optional<Mat3> orientation = {};       ///< A2
  std::optional<std::int64_t> breaks = {};
  std::optional<double> volume_fraction = {};
  std::optional<double> max_overlap = {};  ///< radii
  std::optional<PhaseTimes> timings = {};
  std::vector<std::pair<std::string, SummaryValue>> own = {};  ///< keys of the study's own
};

/// Fills in what follows from the fibers: time, steps, counts, lengths, orientation, breaks, volume
/// fraction.
void describe_fibers(RunSummary& summary, const FiberState& state);

/// Writes the file in one step; raises StorageError.
void write_summary(const std::string& path, const RunSummary& summary);

/// Makes a name that can be part of a key: "Loc. 1" becomes "Loc__1".
[[nodiscard]] std::string key_part(const std::string& name);

/// Gives the values of a summary file.
class SummaryFile {
 public:
  /// Raises StorageError when the file is missing or not JSON.
  explicit SummaryFile(const std::string& path);
  SummaryFile(SummaryFile&&) noexcept;
  SummaryFile& operator=(SummaryFile&&) noexcept;
  ~SummaryFile();
  [[nodiscard]] double number(const std::string& key) const;       ///< NaN where it is missing or null
  [[nodiscard]] std::int64_t count(const std::string& key) const;  ///< 0 where it is missing
  [[nodiscard]] std::string text(const std::string& key) const;    ///< empty where it is missing
  [[nodiscard]] Mat3 tensor(const std::string& key) const;         ///< NaN where it is missing
  [[nodiscard]] std::vector<double> numbers(const std::string& key) const;  ///< empty where they are missing
  /// Lists every value in the order of the file; leaves out what is null or of another kind (`timings`).
  [[nodiscard]] std::vector<std::pair<std::string, SummaryValue>> values() const;
  /// Lists the seconds of each phase in the order of phase_names; empty where they are missing.
  [[nodiscard]] std::vector<double> timings() const;

 private:
  struct Document;
  std::unique_ptr<Document> document_;
};

/// Reads a summary; nothing where there is none, because the run has not ended. Raises as SummaryFile.
[[nodiscard]] std::optional<SummaryFile> read_summary(const std::string& path);

}  // namespace fiberfate
