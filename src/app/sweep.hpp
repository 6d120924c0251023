// What the option --sweep asks for: keys, their values, and the runs that these make.
#pragma once

#include <string>
#include <vector>

namespace fiberfate {

/// One key and the values that it takes one after the other.
struct SweptKey {
  std::string key;
  std::vector<std::string> values;  ///< as written
};

/// Reads "flow.rate=1 1/s,10 1/s"; commas in quotes and brackets part nothing. Raises InputError.
[[nodiscard]] SweptKey read_swept_key(const std::string& text);

/// One run of a sweep.
struct SweepRun {
  std::string folder;                ///< "2_C_I=0.01"
  std::vector<std::string> values;   ///< of every swept key
  std::vector<std::string> changes;  ///< "key=value"
};

/// Lists every combination of the values; those of the last key change fastest. Raises InputError for a key
/// that is given twice and for more runs than anybody means.
[[nodiscard]] std::vector<SweepRun> sweep_runs(const std::vector<SweptKey>& keys);

}  // namespace fiberfate
