// Writes the report of a result.
#include "app/command_report.hpp"

#include <fmt/format.h>

#include "app/case_file.hpp"
#include "app/report_document.hpp"
#include "app/result_folder.hpp"
#include "io/atomic_file.hpp"

namespace fiberfate {

int run_report(const ReportOptions& options) {
  const ResultFolder folder = ResultFolder::open(options.folder);
  const LoadedCase loaded = load_resolved_case(folder.resolved_case());
  replace_file(folder.report(), render_report(loaded.study->report(loaded.values, folder)));
  fmt::print("report in {}\n", folder.report());
  return 0;
}

}  // namespace fiberfate
