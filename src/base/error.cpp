// Formats the errors that a user can meet and finds the word that a misspelt one meant.
#include "base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fiberfate {
namespace {

std::string join_messages(const std::vector<InputProblem>& problems) {
  std::string text;
  for (const InputProblem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += problem.message();
  }
  return text;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::string InputProblem::message() const {
  std::string text;
  if (!file.empty()) text += file + ':';
  if (line > 0) text += fmt::format("{}:", line);
  if (column > 0) text += fmt::format("{}:", column);
  if (!text.empty()) text += ' ';
  if (!key.empty()) text += value.empty() ? key + ": " : fmt::format("{} = {}: ", key, value);
  text += complaint;
  if (!remedy.empty()) text += ": " + remedy;
  return text;
}

InputError::InputError(std::vector<InputProblem> problems)
    : std::runtime_error(join_messages(problems)), problems_(std::move(problems)) {}

InputError::InputError(std::string complaint, std::string remedy)
    : InputError(std::vector<InputProblem>{{"", 0, 0, "", "", std::move(complaint), std::move(remedy)}}) {}

namespace {

/// Tells the place of a failure, as far as it has one: a law at a point has neither fiber nor step.
std::string describe(const FailurePlace& place) {
  std::string text;
  if (place.fiber >= 0) text += fmt::format("fiber {}, ", place.fiber);
  if (place.fiber >= 0 || place.step > 0)
    text += fmt::format("step {}, time {:.9g} s", place.step, place.time);
  if (place.largest_force > 0) text += fmt::format(", largest force {:.4g} N", place.largest_force);
  return text.empty() ? text : " (" + text + ')';
}

}  // namespace

SimulationFailure::SimulationFailure(const std::string& what, FailurePlace place)
    : std::runtime_error(what + describe(place)), place_(place) {}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  std::string_view nearest;
  std::size_t allowed = std::max<std::size_t>(2, word.size() / 3);
  for (const std::string& candidate : candidates) {
    // Their lengths alone put words apart; very long ones cost nothing then.
    if (std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size()) > allowed) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance > allowed || distance >= candidate.size()) continue;
    if (!nearest.empty() && distance == allowed) continue;
    nearest = candidate;
    allowed = distance;
  }
  return std::string(nearest);
}

}  // namespace fiberfate
