// Writes the report of a result.
#include "app/command_report.hpp"

#include "app/study_registry.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/version.hpp"
#include "io/atomic_file.hpp"
#include "keys/case_file.hpp"
#include "results/report_document.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {

int run_report(const ReportOptions& options) {
  const ResultFolder folder = ResultFolder::open(options.folder);
  const LoadedCase loaded = load_resolved_case(folder.resolved_case(), case_kinds());
  ReportDocument document = study_of(loaded).report(loaded.values, folder);
  document.subtitle = std::filesystem::path(folder.path()).filename().string();
  document.study = loaded.kind->name;
  document.version = version;
  replace_file(folder.report(), render_report(document));
  fmt::print("report in {}\n", folder.report());
  return 0;
}

}  // namespace fiberfate
