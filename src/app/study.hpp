// Lists the studies that a case file can ask for; to add one is one line in study.cpp.
#pragma once

#include <any>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/key_table.hpp"

namespace fiberfate {

class CaseChecker;
class ResultFolder;
struct ReportDocument;

/// Says why a run ended; the names go to summary.json as stop_reason.
enum class StopReason { done, time_reached, steps_reached, signal };
[[nodiscard]] const char* name(StopReason reason);

/// Says how a run shows that it is alive.
enum class ProgressKind { automatic, line, log, none };

/// Holds what the command line changes about a case file, in the order in which it is applied.
struct CaseChanges {
  std::vector<std::string> variants;   ///< tables of the variants.toml beside the case file
  std::vector<std::string> overrides;  ///< "key=value"
};

/// Holds what the command line says about one run; what the case says is in the case.
struct RunOptions {
  std::string case_file;              ///< of `run`; empty when resuming
  std::string out;                    ///< result folder; empty: named after the case file
  std::optional<int> threads;         ///< instead of run.threads
  std::optional<double> until;        ///< simulated time at which to stop, s, instead of run.duration
  std::optional<std::int64_t> steps;  ///< most steps to make in this call
  CaseChanges changes;
  ProgressKind progress = ProgressKind::automatic;
  enum class Existing { refuse, overwrite } existing = Existing::refuse;
};

/// Foretells what a run needs and names what follows from the case, for `check`.
struct CaseEstimate {
  std::vector<std::pair<std::string, std::string>>
      facts;  ///< what follows from the case: ("fibers", "628"), …
  double memory_bytes = 0;
  double wall_seconds = 0;
  std::string assumption;  ///< on which the times rest
};

/// Holds the case struct of some study; only that study's functions look inside.
using CaseValues = std::any;

/// Gathers the functions of one study. All of them are pure but run, resume and report.
struct Study {
  std::string name;
  std::string summary;                                            ///< one line
  std::function<CaseValues()> make;                               ///< a case with all defaults
  std::function<void(KeyTable&, CaseValues&)> describe;           ///< adds every key
  std::function<void(const CaseValues&, CaseChecker&)> validate;  ///< finds contradictions between keys
  std::function<CaseEstimate(const CaseValues&)> estimate;
  std::function<StopReason(const CaseValues&, const RunOptions&, ResultFolder&)> run;
  std::function<StopReason(const CaseValues&, const RunOptions&, ResultFolder&)> resume;
  std::function<ReportDocument(const CaseValues&, const ResultFolder&)> report;
};

/// Gathers the same functions, typed by the study's own case struct.
template <class Case>
struct StudyFunctions {
  std::string name;
  std::string summary;
  void (*describe)(KeyTable&, Case&);
  void (*validate)(const Case&, CaseChecker&);
  CaseEstimate (*estimate)(const Case&);
  StopReason (*run)(const Case&, const RunOptions&, ResultFolder&);
  StopReason (*resume)(const Case&, const RunOptions&, ResultFolder&);
  ReportDocument (*report)(const Case&, const ResultFolder&);
};

/// Tells all studies.
[[nodiscard]] const std::vector<Study>& studies();
/// Finds a study by name; null when there is none.
[[nodiscard]] const Study* find_study(const std::string& name);
/// Lists the names of all studies.
[[nodiscard]] std::vector<std::string> study_names();

}  // namespace fiberfate
