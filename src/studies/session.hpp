// How one study runs: its threads, when to stop, who watches, and where results go.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "results/outcome.hpp"
#include "results/recorder.hpp"

namespace fiberfate {

/// What the caller says about one run; what the case says is in the case.
struct SessionOptions {
  std::optional<int> threads = {};         ///< instead of run.threads
  std::optional<double> until = {};        ///< simulated time at which to stop, s, instead of run.duration
  std::optional<std::int64_t> steps = {};  ///< most steps to make in this run
};

/// Whether a run begins or goes on from the recorder's last checkpoint.
enum class Begin { anew, where_it_stopped };

/// How the caller takes part while a study runs; empty functions are never called.
struct SessionCalls {
  std::function<bool()> stop_requested = {};
  /// Is offered a text about how far the run is, which costs nothing until it is made.
  std::function<void(const std::function<std::string()>&)> progress = {};
  /// Is told that the progress shown so far is over, so that other output may follow.
  std::function<void()> progress_ended = {};
};

/// One run of one study. The command line makes one with signals and a progress line, a library without.
class Session {
 public:
  explicit Session(Recorder& recorder, SessionOptions options = {}, SessionCalls calls = {},
                   Begin begin = Begin::anew);

  [[nodiscard]] Recorder& recorder() const { return recorder_; }
  [[nodiscard]] const SessionOptions& options() const { return options_; }
  /// Whether this run goes on from a checkpoint that the recorder has.
  [[nodiscard]] bool continues() const;
  /// Whether the caller wants the run to stop.
  [[nodiscard]] bool stop_requested() const;
  /// Ends the run where the caller wants it to stop and nothing of it can be kept; raises NoOutcome with the
  /// message.
  void end_if_stopped(const std::string& message) const;
  /// Offers a text about how far the run is.
  void show(const std::function<std::string()>& text) const;
  void end_progress() const;
  /// Uses the threads of the caller, or else those of the case (0: all that the machine has), and tells how
  /// many they are.
  int use_threads(int of_case) const;
  /// Wall and processor seconds since the session began.
  [[nodiscard]] double wall_s() const;
  [[nodiscard]] double cpu_s() const;

 private:
  Recorder& recorder_;
  SessionOptions options_;
  SessionCalls calls_;
  Begin begin_;
  double begin_wall_;
  double begin_cpu_;
};

}  // namespace fiberfate
