// Runs a study into a result folder.
#include "app/run_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "app/exit_status.hpp"
#include "app/signals.hpp"
#include "app/study_registry.hpp"
#include "base/error.hpp"
#include "results/folder_recorder.hpp"

namespace fiberfate {
namespace {

/// How a run ended, and whether its folder is the result now.
struct Ending {
  StopReason reason = StopReason::done;
  bool stands = true;
};

/// Quotes a path for a shell where it needs quotes.
std::string shell_word(const std::string& path) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("_./-+,=@%").find(static_cast<char>(c)) != std::string::npos;
  };
  if (std::all_of(path.begin(), path.end(), is_plain)) return path;
  std::string quoted = "'";
  for (const char c : path) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// What stands on the terminal at last: where the result is, and the command that most people want next.
std::string next_step(const Ending& ending, const std::string& path) {
  if (!ending.stands) return fmt::format("the earlier result in {} stays", path);
  const std::string word = shell_word(path);
  switch (ending.reason) {
    case StopReason::done:
      return fmt::format("result in {0}; look at it: fiberfate report {1}", path, word);
    case StopReason::time_reached:
      return fmt::format("stopped at the time of --until; go on: fiberfate resume {}", word);
    case StopReason::steps_reached:
      return fmt::format("stopped after the steps of --steps; go on: fiberfate resume {}", word);
    case StopReason::signal:
      break;
  }
  return fmt::format("interrupted, and saved; go on: fiberfate resume {}", word);
}

/// Writes what the study computes and shows its headlines.
Ending compute_into(OwnedFolder& folder, const LoadedCase& loaded, Session& session) {
  try {
    Outcome outcome = study_of(loaded).compute(loaded.values, session);
    if (outcome.summary.wall_s == 0) outcome.summary.wall_s = session.wall_s();
    if (outcome.summary.cpu_s == 0) outcome.summary.cpu_s = session.cpu_s();
    for (const std::string& line : outcome.headlines) session.recorder().note(line);
    write_outcome(outcome, folder);
    folder.keep();
    folder.end();
    for (const std::string& line : outcome.headlines) fmt::print("{}\n", line);
    return {outcome.summary.stop_reason};
  } catch (const NoOutcome& end) {
    session.end_progress();
    session.recorder().warn(end.message);
    // What was stopped before it began to show anything does not replace an earlier result.
    const Ending ending{end.reason, !folder.replaces()};
    if (ending.stands) folder.keep();
    if (end.reason == StopReason::done) folder.end();
    return ending;
  } catch (const SimulationFailure& failure) {
    const std::string path = folder.folder().path(), now_in = folder.set_aside();
    if (now_in == path) throw;
    throw SimulationFailure(fmt::format("{}; what it made is in {}, and {} holds the earlier result again",
                                        failure.what(), now_in, path),
                            failure.place());
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
  const Ending ending = compute_into(folder, loaded, session);
  fmt::print("{}\n", next_step(ending, folder.folder().path()));
  return static_cast<int>(ending.reason == StopReason::signal ? ExitStatus::stopped : ExitStatus::done);
}

int run_anew(const LoadedCase& loaded, const RunOptions& options, const std::string& path) {
  OwnedFolder folder = OwnedFolder::create(path, options.existing);
  folder.write_case(resolved_case(*loaded.kind, loaded.values));
  return run_study(loaded, options, std::move(folder), Begin::anew);
}

}  // namespace fiberfate
