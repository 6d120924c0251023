// Runs a case for every combination of the values of a sweep.
#include "app/run_sweep.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <set>

#include "app/exit_status.hpp"
#include "app/run_study.hpp"
#include "app/say.hpp"
#include "app/signals.hpp"
#include "app/study_registry.hpp"
#include "app/sweep.hpp"
#include "app/sweep_table.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"

namespace fiberfate {
namespace {

/// Reads the cases of all runs at once, so that none is refused when others have run for hours.
std::vector<LoadedCase> load_all(const RunOptions& options, const std::vector<SweepRun>& runs) {
  std::vector<LoadedCase> cases;
  std::vector<InputProblem> problems;
  std::set<std::string> told;
  for (const SweepRun& run : runs) {
    try {
      CaseChanges changes = options.changes;
      changes.overrides.insert(changes.overrides.end(), run.changes.begin(), run.changes.end());
      cases.push_back(load_case(options.case_file, case_kinds(), changes));
      check_options(study_of(cases.back()), options.session);
      for (const std::string& warning : cases.back().warnings)
        if (told.insert(warning).second) say(fmt::format("warning: {}\n", warning));
    } catch (const InputError& error) {
      for (const InputProblem& problem : error.problems())
        if (told.insert(problem.message()).second) problems.push_back(problem);
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  return cases;
}

/// Runs one case; what ends it is told and becomes its status.
ExitStatus run_one(const LoadedCase& loaded, const RunOptions& options, const std::string& path) {
  try {
    return static_cast<ExitStatus>(run_anew(loaded, options, path));
  } catch (const SimulationFailure& error) {
    say(fmt::format("fiberfate: {}: the simulation failed: {}\n", path, error.what()));
  } catch (const InputError& error) {
    say(fmt::format("{}: {}\n", path, error.what()));
    return ExitStatus::bad_input;
  }
  return ExitStatus::failed;
}

std::vector<std::pair<std::string, SummaryValue>> summary_of(const std::string& path, ExitStatus status) {
  if (status == ExitStatus::done || status == ExitStatus::stopped)
    if (const std::string file = path + "/summary.json"; std::filesystem::exists(file))
      return SummaryFile(file).values();
  return {{"stop_reason", status == ExitStatus::stopped ? "signal" : "failed"}};
}

}  // namespace

int run_sweep(const RunOptions& options, const std::string& path) {
  std::vector<SweptKey> keys;
  std::vector<std::string> columns = {"run"};
  for (const std::string& text : options.sweep) {
    keys.push_back(read_swept_key(text));
    columns.push_back(keys.back().key);
  }
  const std::vector<SweepRun> runs = sweep_runs(keys);
  const std::vector<LoadedCase> cases = load_all(options, runs);
  OwnedFolder folder = OwnedFolder::create(path, options.existing);
  const std::string file = folder.make("sweep.csv");
  SweepTable table(columns);
  ExitStatus worst = ExitStatus::done;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SweepRun& run = runs[i];
    const std::string run_path = folder.folder().file(run.folder);
    const ExitStatus status = run_one(cases[i], options, run_path);
    if (status != ExitStatus::done) worst = status;
    std::vector<std::string> cells = {run.folder};
    cells.insert(cells.end(), run.values.begin(), run.values.end());
    table.add(std::move(cells), summary_of(run_path, status));
    replace_file(file, table.text());
    folder.keep();
    if (!stop_requested()) continue;
    worst = ExitStatus::stopped;
    break;
  }
  fmt::print("table of {} of {} runs in {}\n", table.rows(), runs.size(), file);
  return static_cast<int>(worst);
}

}  // namespace fiberfate
