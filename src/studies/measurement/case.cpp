// Reads lists of measured fibers and checks a case of the study measurement.
#include "studies/measurement/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/error.hpp"
#include "base/units.hpp"
#include "io/input_file.hpp"
#include "results/memory_recorder.hpp"
#include "studies/measurement/lists.hpp"
#include "studies/measurement/run.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

/// Gathers the faults of a file in one, each with its place there.
std::string told_together(const std::vector<InputProblem>& problems) {
  constexpr std::size_t most_told = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(problems.size(), most_told); ++i)
    text += (i > 0 ? "; " : "") + complaint_with_place(problems[i]);
  if (problems.size() > most_told) text += fmt::format("; and {} more", problems.size() - most_told);
  return text;
}

/// Reads a list and reports what is wrong in it, at the key that it names or else at the file's.
template <class Read>
void check_list(const std::string& file_key, CaseChecker& checker, const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    const InputProblem& first = error.problems().front();
    checker.error(first.key.empty() ? file_key : first.key, told_together(error.problems()), first.remedy);
  }
}

/// Reads the list, and refuses bins so narrow that they are too many.
void check_lengths(const MeasuredLengthChoices& lengths, CaseChecker& checker) {
  const MeasuredLengths fibers = read_lengths(lengths).fibers;
  static_cast<void>(number_average(fibers));
  const double longest = *std::max_element(fibers.lengths.begin(), fibers.lengths.end());
  if (!lengths.bin_width || longest / *lengths.bin_width <= most_histogram_bins) return;
  checker.error(
      "lengths.bin_width",
      fmt::format("more than {} bins up to the longest fiber, {:.3g} mm", most_histogram_bins, longest * 1e3),
      fmt::format("give at least \"{:.2g} um\"", 1.1e6 * longest / most_histogram_bins));
}

void validate_lengths(const MeasuredLengthChoices& lengths, CaseChecker& checker) {
  if (lengths.file.empty()) {
    checker.warn_unused({"lengths.column", "lengths.number_column", "lengths.unit", "lengths.sample_diameter",
                         "lengths.bins", "lengths.bin_width"},
                        "a given lengths.file");
    return;
  }
  if (lengths.bin_width) checker.warn_unused({"lengths.bins"}, "a case without lengths.bin_width");
  try {
    if (!lengths.unit.empty()) static_cast<void>(unit_factor(lengths.unit, "m"));
  } catch (const std::invalid_argument& problem) {
    checker.error("lengths.unit", problem.what(), "give a unit of length such as \"um\"");
    return;
  }
  checker.check_file("lengths.file", lengths.file);
  if (checker.is_sound("lengths.file"))
    check_list("lengths.file", checker, [&] { check_lengths(lengths, checker); });
}

void validate_directions(const MeasuredDirectionChoices& orientation, CaseChecker& checker) {
  if (orientation.file.empty()) {
    checker.warn_unused({"orientation.form", "orientation.columns", "orientation.angle_unit",
                         "orientation.weight_column", "orientation.cut_normal", "orientation.aspect_ratio"},
                        "a given orientation.file");
    return;
  }
  if (orientation.form == DirectionForm::vectors)
    checker.warn_unused({"orientation.angle_unit"}, "orientation.form = \"angles\"");
  const std::size_t wanted = orientation.form == DirectionForm::angles ? 2 : 3;
  if (!orientation.columns.empty() && orientation.columns.size() != wanted)
    checker.error(
        "orientation.columns",
        fmt::format("{} columns where {} are needed", orientation.columns.size(), wanted),
        wanted == 2 ? "name the columns of theta and phi" : "name the columns of the three components");
  if (orientation.cut_normal && !(orientation.cut_normal->norm() > 0))
    checker.error("orientation.cut_normal", "has no direction", "give a vector across the cut");
  if (orientation.cut_normal && !orientation.aspect_ratio)
    checker.error("orientation.aspect_ratio", "not given; the correction for a cut needs it",
                  "add aspect_ratio = 20 under [orientation]");
  if (!orientation.cut_normal)
    checker.warn_unused({"orientation.aspect_ratio"}, "a given orientation.cut_normal");
  checker.check_file("orientation.file", orientation.file);
  if (checker.is_sound("orientation.file") && checker.is_sound("orientation.columns") &&
      checker.is_sound("orientation.cut_normal") && checker.is_sound("orientation.aspect_ratio"))
    check_list("orientation.file", checker,
               [&] { static_cast<void>(second_moment(read_directions(orientation).fibers)); });
}

}  // namespace

void validate_measurement(const MeasurementCase& values, CaseChecker& checker) {
  if (values.lengths.file.empty() && values.orientation.file.empty() && checker.is_sound("lengths.file") &&
      checker.is_sound("orientation.file"))
    checker.error("lengths.file", "not given, nor is orientation.file; there is nothing to evaluate",
                  "add file = \"lengths.csv\" under [lengths], or a file under [orientation]");
  validate_lengths(values.lengths, checker);
  validate_directions(values.orientation, checker);
}

namespace {

/// The wall seconds of a run with so many bootstrap samples.
double seconds_with(MeasurementCase values, std::int64_t resamples) {
  values.statistics.resamples = resamples;
  MemoryRecorder recorder;
  Session session(recorder);
  const Stopwatch watch;
  static_cast<void>(compute_measurement(values, session));
  return watch.elapsed();
}

/// Foretells the wall seconds of a run on so many rows from two with fewer bootstrap samples.
double expected_seconds(const MeasurementCase& values, double rows) {
  constexpr double trial_draws = 1e6;
  const std::int64_t resamples = values.statistics.resamples;
  const auto some = static_cast<std::int64_t>(std::max(20.0, trial_draws / rows));
  if (some >= resamples) return seconds_with(values, resamples);
  const double few = seconds_with(values, some / 2), more = seconds_with(values, some);
  return more + std::max(0.0, more - few) * static_cast<double>(resamples - some) /
                    static_cast<double>(some - some / 2);
}

}  // namespace

CaseEstimate estimate_measurement(const MeasurementCase& values) {
  CaseEstimate estimate;
  double rows = 0;
  if (!values.lengths.file.empty()) {
    const LengthList list = read_lengths(values.lengths);
    const std::size_t lengths = list.fibers.lengths.size();
    estimate.facts.emplace_back("rows of lengths", std::to_string(lengths));
    estimate.facts.emplace_back("column of lengths", list.column);
    if (const std::string text = list.left_out.text(); !text.empty())
      estimate.facts.emplace_back("of the lengths", text);
    rows += static_cast<double>(lengths);
  }
  if (!values.orientation.file.empty()) {
    const std::size_t directions = read_directions(values.orientation).fibers.directions.size();
    estimate.facts.emplace_back("rows of directions", std::to_string(directions));
    rows += static_cast<double>(directions);
  }
  // Means of every sample, and a component of them sorted; lists grow by doubling.
  const double means = (values.lengths.file.empty() ? 0 : 40) + (values.orientation.file.empty() ? 0 : 104);
  estimate.memory_bytes = 1e7 + 100 * rows + means * static_cast<double>(values.statistics.resamples);
  foretell(
      estimate, [&] { return expected_seconds(values, rows); }, "from a trial with fewer bootstrap samples");
  return estimate;
}

}  // namespace fiberfate
