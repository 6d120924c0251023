// Shows that a run is alive: one line that renews itself on a terminal, a plain line now and then elsewhere.
#pragma once

#include <functional>
#include <string>

namespace fiberfate {

/// How a run shows that it is alive.
enum class ProgressKind { automatic, line, log, none };

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
