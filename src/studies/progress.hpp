// Shows that a run is alive: one line that renews itself on a terminal, a plain line now and then elsewhere.
#pragma once

#include <functional>
#include <string>

#include "studies/study.hpp"

namespace fiberfate {

/// Tells how far a run is.
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

/// Writes progress to standard error.
class Progress {
 public:
  explicit Progress(ProgressKind kind);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows a text where one is due; the text is made only then.
  void show(const std::function<std::string()>& text);
  /// Ends the line that renews itself, so that other output starts on a new one.
  void end_line();

 private:
  ProgressKind kind_;
  double next_ = 0;
  double interval_ = 0;
  bool line_is_open_ = false;
};

}  // namespace fiberfate
