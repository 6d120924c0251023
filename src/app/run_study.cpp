// Runs a study into a result folder.
#include "app/run_study.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "app/exit_status.hpp"
#include "app/signals.hpp"
#include "app/study_registry.hpp"
#include "base/error.hpp"
#include "results/folder_recorder.hpp"

namespace fiberfate {
namespace {

/// Writes what the study computes and tells why it ended.
StopReason compute_into(OwnedFolder& folder, const LoadedCase& loaded, Session& session) {
  try {
    Outcome outcome = study_of(loaded).compute(loaded.values, session);
    if (outcome.summary.wall_s == 0) outcome.summary.wall_s = session.wall_s();
    if (outcome.summary.cpu_s == 0) outcome.summary.cpu_s = session.cpu_s();
    write_outcome(outcome, folder);
    folder.keep();
    folder.end();
    return outcome.summary.stop_reason;
  } catch (const NoOutcome& end) {
    session.end_progress();
    session.recorder().warn(end.message);
    // What was stopped before it began to show anything does not replace an earlier result.
    if (!folder.replaces()) folder.keep();
    if (end.reason == StopReason::done) folder.end();
    return end.reason;
  } catch (const SimulationFailure&) {
    folder.keep();
    throw;
  } catch (const StorageError&) {
    if (session.recorder().has_checkpoint() || !folder.replaces()) folder.stand();
    throw;
  }
}

}  // namespace

void check_options(const Study& study, const SessionOptions& options) {
  struct Option {
    const char* name;
    bool given, taken;
    const char* meaning;
  };
  const std::array all = {
      Option{"--threads", options.threads.has_value(), study.takes.threads, "runs on one thread"},
      Option{"--until", options.until.has_value(), study.takes.until, "always runs to its end"},
      Option{"--steps", options.steps.has_value(), study.takes.steps, "does not count steps"}};
  std::vector<InputProblem> problems;
  for (const Option& one : all)
    if (one.given && !one.taken)
      problems.push_back({"", 0, 0, one.name, "", fmt::format("the study {} {}", study.name, one.meaning),
                          fmt::format("leave {} out", one.name)});
  if (!problems.empty()) throw InputError(std::move(problems));
}

int run_study(const LoadedCase& loaded, const RunOptions& options, OwnedFolder folder, Begin begin) {
  watch_for_signals();
  Progress progress(options.progress);
  FolderRecorder recorder(folder);
  SessionCalls calls;
  calls.stop_requested = stop_requested;
  calls.progress = [&progress](const std::function<std::string()>& text) { progress.show(text); };
  calls.progress_ended = [&progress] { progress.end_line(); };
  Session session(recorder, options.session, std::move(calls), begin);
  if (begin == Begin::where_it_stopped && !recorder.has_checkpoint())
    recorder.warn("there is no checkpoint to go on from: the run begins again");
  const StopReason reason = compute_into(folder, loaded, session);
  fmt::print("{}: result in {}\n", name(reason), folder.folder().path());
  return static_cast<int>(reason == StopReason::signal ? ExitStatus::stopped : ExitStatus::done);
}

int run_anew(const LoadedCase& loaded, const RunOptions& options, const std::string& path) {
  OwnedFolder folder = OwnedFolder::create(path, options.existing);
  folder.write_case(resolved_case(*loaded.kind, loaded.values));
  return run_study(loaded, options, std::move(folder), Begin::anew);
}

}  // namespace fiberfate
