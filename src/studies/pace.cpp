// Foretells how long work takes.
#include "studies/pace.hpp"

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "base/timer.hpp"

namespace fiberfate {

Stopwatch::Stopwatch() : wall_(wall_seconds()), processor_(cpu_seconds()) {}

double Stopwatch::elapsed() const {
  return std::min(wall(), cpu_seconds() - processor_);
}

double Stopwatch::wall() const {
  return wall_seconds() - wall_;
}

Pace::Pace(double trial_s) : trial_(trial_s) {}

bool Pace::has_time() const {
  constexpr std::size_t few = 8;
  constexpr double patience = 10, longest_wait = 100;
  const double now = watch_.elapsed();
  if (watch_.wall() > longest_wait * trial_) return false;
  return now < trial_ || (marks_.size() < few && now < patience * trial_);
}

void Pace::reached(double share) {
  if (share > 0) marks_.push_back({watch_.elapsed(), std::min(share, 1.0)});
}

double Pace::whole() const {
  if (marks_.empty()) return 0;
  const Mark& last = marks_.back();
  if (last.share >= 1) return last.time;
  const auto half = std::find_if(marks_.begin(), marks_.end(),
                                 [&last](const Mark& mark) { return mark.time >= 0.5 * last.time; });
  const double time = half->share < last.share ? last.time - half->time : last.time;
  const double share = half->share < last.share ? last.share - half->share : last.share;
  return share > 0 ? last.time + (1 - last.share) * time / share : 0;
}

void foretell(CaseEstimate& estimate, const std::function<double()>& trial, const std::string& assumption) {
  std::string failure;
  try {
    estimate.wall_seconds = trial();
    estimate.assumption = assumption;
    return;
  } catch (const SimulationFailure& error) {
    failure = error.what();
  } catch (const InputError& error) {
    if (!error.problems().front().file.empty()) throw;  // no run can read that file either
    failure = error.what();
  }
  estimate.wall_seconds = std::numeric_limits<double>::quiet_NaN();
  estimate.assumption = "a trial failed: " + failure;
}

std::vector<double> with_early_times(const std::vector<double>& times) {
  constexpr int halvings = 6;
  std::vector<double> all;
  const auto first = std::find_if(times.begin(), times.end(), [](double time) { return time > 0; });
  all.assign(times.begin(), first);
  if (first == times.end()) return all;
  double time = *first;
  for (int i = 0; i < halvings; ++i) time /= 2;
  for (; time < *first; time *= 2) all.push_back(time);
  all.insert(all.end(), first, times.end());
  return all;
}

}  // namespace fiberfate
