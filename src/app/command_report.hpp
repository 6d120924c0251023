// The command report.
#pragma once

#include <string>

namespace fiberfate {

struct ReportOptions {
  std::string folder;
};

/// Writes folder/report.html; returns the exit status.
int run_report(const ReportOptions& options);

}  // namespace fiberfate
