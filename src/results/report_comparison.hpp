// Puts the reports of several runs of one study onto one page: numbers side by side, a line a run in every
// chart.
#pragma once

#include <string>
#include <vector>

#include "results/report_document.hpp"

namespace fiberfate {

/// One key of a case as it was resolved.
struct ResolvedKey {
  std::string name;   ///< "flow.rate"
  std::string value;  ///< as in case.resolved.toml, "10.0"
  std::string unit = {};
};

/// One run that is compared.
struct ComparedRun {
  std::string name;  ///< of its folder
  ReportDocument document;
  std::vector<ResolvedKey> keys;
};

/// Makes one document of those of several runs. Runs whose cases differ only in their seed and in keys that
/// change no result are replicas: one line, their mean, with a band from the least of them to the largest.
/// What all runs share is drawn once. Pictures, maps and tables stay with the report of each run.
[[nodiscard]] ReportDocument compare_reports(const std::vector<ComparedRun>& runs);

}  // namespace fiberfate
