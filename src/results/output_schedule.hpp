// Tells when the outputs of a run are due.
#pragma once

#include <vector>

namespace fiberfate {

/// Holds the times at which one kind of output is due: all multiples of an interval, and some more.
/// It has no memory, so a resumed run meets the same times.
struct OutputSchedule {
  double interval = 0;         ///< s
  std::vector<double> others;  ///< s

  /// Tells the first time of output after `time`; times nearer than a millionth of the interval are one.
  [[nodiscard]] double next(double time) const;
  /// Tells whether output is due at this time.
  [[nodiscard]] bool includes(double time) const;
  /// Tells the multiple of the interval that `time` means up to round-off, or `time` itself.
  [[nodiscard]] double snapped(double time) const;
};

}  // namespace fiberfate
