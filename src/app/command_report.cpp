// Writes the report of a result.
#include "app/command_report.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/case_file.hpp"
#include "app/report_document.hpp"
#include "app/result_folder.hpp"
#include "base/version.hpp"
#include "io/atomic_file.hpp"

namespace fiberfate {

int run_report(const ReportOptions& options) {
  const ResultFolder folder = ResultFolder::open(options.folder);
  const LoadedCase loaded = load_resolved_case(folder.resolved_case());
  ReportDocument document = loaded.study->report(loaded.values, folder);
  document.subtitle = std::filesystem::path(folder.path()).filename().string();
  document.study = loaded.study->name;
  document.version = version;
  replace_file(folder.report(), render_report(document));
  fmt::print("report in {}\n", folder.report());
  return 0;
}

}  // namespace fiberfate
