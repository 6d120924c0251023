// What a study is: functions of its case struct.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "keys/case_file.hpp"
#include "results/run_types.hpp"

namespace fiberfate {

class CaseChecker;
class ResultFolder;
struct ReportDocument;

/// Says how a run shows that it is alive.
enum class ProgressKind { automatic, line, log, none };

/// Holds what the command line says about one run; what the case says is in the case.
struct RunOptions {
  std::string case_file;              ///< of `run`; empty when resuming
  std::string out;                    ///< result folder; empty: named after the case file
  std::optional<int> threads;         ///< instead of run.threads
  std::optional<double> until;        ///< simulated time at which to stop, s, instead of run.duration
  std::optional<std::int64_t> steps;  ///< most steps to make in this call
  CaseChanges changes;
  ProgressKind progress = ProgressKind::automatic;
  Existing existing = Existing::refuse;
};

/// Foretells what a run needs and names what follows from the case, for `check`.
struct CaseEstimate {
  std::vector<std::pair<std::string, std::string>>
      facts;  ///< what follows from the case: ("fibers", "628"), …
  double memory_bytes = 0;
  double wall_seconds = 0;
  std::string assumption;  ///< on which the times rest
};

/// Gathers the functions of one study. All of them are pure but run, resume and report.
struct Study : CaseKind {
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

}  // namespace fiberfate
