// Writes the report of a result.
#include "app/command_report.hpp"

#include "app/study_registry.hpp"
#include "base/error.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "base/version.hpp"
#include "io/atomic_file.hpp"
#include "keys/case_file.hpp"
#include "results/report_document.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"

namespace fiberfate {

namespace {

/// The name of the folder also where its path ends in a slash or is ".".
std::string folder_name(const std::string& path) {
  const std::filesystem::path whole = std::filesystem::weakly_canonical(path);
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

}  // namespace

int run_report(const ReportOptions& options) {
  const ResultFolder folder = ResultFolder::open(options.folder);
  const LoadedCase loaded = load_resolved_case(folder.resolved_case(), case_kinds());
  if (!std::filesystem::exists(folder.summary()) && !std::filesystem::exists(folder.frames()))
    throw InputError(folder.path() + " has nothing to show: the run ended before its first result",
                     "continue it with 'fiberfate resume', or run the case again");
  ReportDocument document = study_of(loaded).report(loaded.values, folder);
  document.case_name = folder_name(folder.path());
  document.study = loaded.kind->name;
  document.version = version;
  const std::optional<SummaryFile> summary = read_summary(folder.summary());
  document.stop_reason = summary ? summary->text("stop_reason") : "unfinished";
  const std::string page = render_report(document);
  if (std::filesystem::exists(folder.report()) && !recorded_files(folder.path()).contains("report.html"))
    throw InputError(folder.report() + " is there already, and fiberfate did not make it", "move it away");
  record_file(folder.path(), "report.html");
  replace_file(folder.report(), page);
  fmt::print("report in {}\n", folder.report());
  return 0;
}

}  // namespace fiberfate
