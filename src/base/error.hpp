// The errors that a user can meet: bad input, a failed simulation, a result that cannot be written.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fiberfate {

/// Describes one thing that is wrong with an input, and what to do about it.
struct InputProblem {
  std::string file;       ///< path as the user gave it; empty when the command line is at fault
  int line = 0;           ///< from 1; 0 when no line can be named
  int column = 0;         ///< from 1; 0 when no column can be named
  std::string key;        ///< the full key, "fibers.length"
  std::string value;      ///< the offending value as written
  std::string complaint;  ///< what is wrong
  std::string remedy;     ///< what to do

  /// Formats "file:line:column: key = value: complaint: remedy", leaving out what is unknown.
  [[nodiscard]] std::string message() const;
};

/// Reports all problems of an input at once; the program exits with status 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<InputProblem> problems);
  /// Reports one problem that has no place in a file.
  InputError(std::string complaint, std::string remedy);
  [[nodiscard]] const std::vector<InputProblem>& problems() const { return problems_; }

 private:
  std::vector<InputProblem> problems_;
};

/// Where and how a simulation failed.
struct FailurePlace {
  std::int64_t step = 0;
  double time = 0;           ///< s
  std::int64_t fiber = -1;   ///< birth id of the fiber; -1 when none is to blame
  double largest_force = 0;  ///< N
};

/// Stops a simulation that cannot go on; the state is dumped and the program exits with status 3.
class SimulationFailure : public std::runtime_error {
 public:
  SimulationFailure(const std::string& what, FailurePlace place);
  [[nodiscard]] const FailurePlace& place() const { return place_; }

 private:
  FailurePlace place_;
};

/// Reports that a result or checkpoint could not be written or read (full disk, missing permission); exit
/// status 3.
class StorageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Finds the candidate that a misspelt word most likely meant, or an empty text when none is near.
/// Nearness is the Damerau-Levenshtein distance; at most a third of the letters (at least 2) may differ.
[[nodiscard]] std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace fiberfate
