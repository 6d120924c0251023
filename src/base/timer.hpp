// Measures wall, processor and per-phase time of a run.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace fiberfate {

/// The phases whose times summary.json reports.
enum class Phase : std::size_t { neighbours, loads, solve, update, breakage, output };
inline constexpr std::size_t phase_count = 6;
inline constexpr std::array<const char*, phase_count> phase_names = {"neighbours", "loads",    "solve",
                                                                     "update",     "breakage", "output"};

/// Accumulates wall seconds by phase.
class PhaseTimes {
 public:
  void add(Phase phase, double seconds) { seconds_[static_cast<std::size_t>(phase)] += seconds; }
  [[nodiscard]] double seconds(Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }

 private:
  std::array<double, phase_count> seconds_{};
};

/// Adds the wall time of its own life to a phase.
class PhaseTimer {
 public:
  PhaseTimer(PhaseTimes& times, Phase phase) : times_(times), phase_(phase), start_(Clock::now()) {}
  ~PhaseTimer() { times_.add(phase_, std::chrono::duration<double>(Clock::now() - start_).count()); }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  PhaseTimes& times_;
  Phase phase_;
  Clock::time_point start_;
};

/// Wall seconds since an arbitrary start.
[[nodiscard]] double wall_seconds();
/// Processor seconds that this process has used, all threads together.
[[nodiscard]] double cpu_seconds();
/// The largest resident memory of this process so far, bytes.
[[nodiscard]] std::size_t peak_memory_bytes();

}  // namespace fiberfate
