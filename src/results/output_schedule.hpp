// When the outputs of a run are due.
#pragma once

#include <vector>

namespace fiberfate {

/// The times at which one kind of output is due: all multiples of an interval, and some more.
/// It has no memory, so a resumed run meets the same times.
struct OutputSchedule {
  double interval = 0;         ///< s
  std::vector<double> others;  ///< s

  /// The first time of output after `time`; times nearer than a millionth of the interval are one.
  [[nodiscard]] double next(double time) const;
  /// Whether output is due at this time.
  [[nodiscard]] bool includes(double time) const;
  /// The multiple of the interval that `time` means up to round-off, or `time` itself.
  [[nodiscard]] double snapped(double time) const;
};

}  // namespace fiberfate
