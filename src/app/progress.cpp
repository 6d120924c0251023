// Shows that a run is alive.
#include "app/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "base/timer.hpp"

namespace fiberfate {
namespace {

constexpr double line_interval = 0.2;        // wall time between renewals of the line on a terminal, s
constexpr double first_log_interval = 5;     // wall time before the first plain line, s
constexpr double longest_log_interval = 60;  // the interval doubles up to this, s

}  // namespace

Progress::Progress(ProgressKind kind) : kind_(kind) {
  if (kind_ == ProgressKind::automatic)
    kind_ = isatty(STDERR_FILENO) != 0 ? ProgressKind::line : ProgressKind::log;
  interval_ = kind_ == ProgressKind::line ? line_interval : first_log_interval;
  next_ = wall_seconds() + (kind_ == ProgressKind::line ? 0 : interval_);
}

Progress::~Progress() {
  end_line();
}

void Progress::show(const std::function<std::string()>& text) {
  if (kind_ == ProgressKind::none || wall_seconds() < next_) return;
  if (kind_ == ProgressKind::line) {
    std::fprintf(stderr, "\r\033[K%s", text().c_str());
    std::fflush(stderr);
    line_is_open_ = true;
  } else {
    std::fprintf(stderr, "%s\n", text().c_str());
    interval_ = std::min(2 * interval_, longest_log_interval);
  }
  next_ = wall_seconds() + interval_;
}

void Progress::end_line() {
  if (line_is_open_) std::fputc('\n', stderr);
  line_is_open_ = false;
}

}  // namespace fiberfate
