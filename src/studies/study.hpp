// What a study is: functions of its case struct.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "keys/case_kind.hpp"
#include "studies/session.hpp"

namespace fiberfate {

class ResultFolder;
struct ReportDocument;

/// What a run needs and what follows from its case, for `check`.
struct CaseEstimate {
  std::vector<std::pair<std::string, std::string>>
      facts;  ///< what follows from the case: ("fibers", "628"), …
  double memory_bytes = 0;
  double wall_seconds = 0;
  std::string assumption;  ///< on which the times rest
};

/// The options of a session that a study acts on; its callers refuse the others.
struct TakenOptions {
  bool threads = false;
  bool until = false;
  bool steps = false;
};

/// What a paper says of a study's method.
struct MethodText {
  const char* sentence = "";  ///< whole sentences in the present tense
  const char* source = "";    ///< author, journal, year; several after "; "
};

/// The functions of one study, for a case of any type. All of them are pure but compute and report.
struct Study : CaseKind {
  TakenOptions takes;
  MethodText method;
  std::function<CaseEstimate(const CaseValues&)> estimate;
  /// Computes what the case asks for. Raises NoOutcome where it was stopped before there is anything,
  /// SimulationFailure, StorageError and, where only the computation can tell, InputError.
  std::function<Outcome(const CaseValues&, Session&)> compute;
  /// Makes the report from the files of a result folder.
  std::function<ReportDocument(const CaseValues&, const ResultFolder&)> report;
};

/// The same functions, typed by the study's own case struct.
template <class Case>
struct StudyFunctions {
  std::string name;
  std::string summary;
  void (*describe)(KeyTable&, Case&);
  void (*validate)(const Case&, CaseChecker&);
  CaseEstimate (*estimate)(const Case&);
  Outcome (*compute)(const Case&, Session&);
  ReportDocument (*report)(const Case&, const ResultFolder&);
  TakenOptions takes = {};
  MethodText method = {};
};

/// Makes a study that takes any case from functions that take its own.
template <class Case>
[[nodiscard]] Study make_study(const StudyFunctions<Case>& typed) {
  const auto of = [](const CaseValues& values) -> const Case& { return *std::any_cast<Case>(&values); };
  Study study{case_kind(typed.name, typed.summary, typed.describe, typed.validate),
              typed.takes,
              typed.method,
              {},
              {},
              {}};
  study.estimate = [typed, of](const CaseValues& values) { return typed.estimate(of(values)); };
  study.compute = [typed, of](const CaseValues& values, Session& session) {
    Outcome outcome = typed.compute(of(values), session);
    outcome.summary.study = typed.name;
    return outcome;
  };
  study.report = [typed, of](const CaseValues& values, const ResultFolder& folder) {
    return typed.report(of(values), folder);
  };
  return study;
}

}  // namespace fiberfate
