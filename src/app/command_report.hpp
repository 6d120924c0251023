// The command report.
#pragma once

#include <string>
#include <vector>

namespace fiberfate {

struct ReportOptions {
  std::vector<std::string> folders;
  std::string out = {};  ///< the page; empty: report.html of one folder, comparison.html beside several
  enum class Existing { refuse, overwrite } existing = Existing::refuse;
};

/// Writes the report of a result, or the comparison of several; returns the exit status.
int run_report(const ReportOptions& options);

}  // namespace fiberfate
