// How long work takes, foretold from a part of it that is done for trial.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "studies/study.hpp"

namespace fiberfate {

/// Tells the wall seconds of some work as they are while nobody else uses the machine: what other processes
/// take from it leaves processor time as it is.
class Stopwatch {
 public:
  Stopwatch();
  [[nodiscard]] double elapsed() const;
  /// The wall seconds as they are.
  [[nodiscard]] double wall() const;

 private:
  double wall_, processor_;
};

/// Times the first part of some work and foretells the whole. The trial ends when its time is used up and a
/// few parts are done:
///
///   Pace pace;
///   while (pace.has_time() && !finished) { step(); pace.reached(share); }
///   seconds = pace.whole();
class Pace {
 public:
  /// Takes the wall seconds that the trial may take.
  explicit Pace(double trial_s = 0.1);
  [[nodiscard]] bool has_time() const;
  /// Tells which share of the whole is done, 0 to 1.
  void reached(double share);
  /// The wall seconds that the whole takes: what was measured, and the rest at the speed of the second half
  /// of the trial, which is past the first allocations. Zero where nothing was reached.
  [[nodiscard]] double whole() const;
  [[nodiscard]] double share() const { return marks_.empty() ? 0 : marks_.back().share; }
  [[nodiscard]] double elapsed() const { return marks_.empty() ? 0 : marks_.back().time; }

 private:
  struct Mark {
    double time, share;
  };
  Stopwatch watch_;
  double trial_;
  std::vector<Mark> marks_;
};

/// Thrown to end a trial, whose time is used up, from within.
struct TrialEnd {};

/// Calls a trial, which gives the wall seconds of a run, for an estimate. Where the trial fails the run will,
/// too: the seconds are then NaN, and the estimate says why. Raises InputError for a fault inside a file.
void foretell(CaseEstimate& estimate, const std::function<double()>& trial, const std::string& assumption);

/// The wall seconds that a frame and a row of a table take: a frame is on the disk before the run goes on.
inline constexpr double seconds_a_frame = 0.012, seconds_a_row = 1e-5;

/// Puts times before the first of rising ones, so that a trial need not wait for it: halves of it.
[[nodiscard]] std::vector<double> with_early_times(const std::vector<double>& times);

}  // namespace fiberfate
