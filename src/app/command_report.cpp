// Writes the report of a result, or the comparison of several.
#include "app/command_report.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "app/comparison.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"

namespace fiberfate {
namespace {

[[noreturn]] void refuse_foreign(const std::string& path) {
  throw InputError(path + " is there already, and fiberfate did not make it", "move it away");
}

/// Whether a file holds a document of ours, as every report does.
bool is_report(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return text.find("id=\"fiberfate-document\"") != std::string::npos;
}

/// Writes a page where the user wants it; only reports are replaced, and where that is wanted.
void write_page(const ReportOptions& options, const std::string& path, const std::string& page) {
  if (std::filesystem::is_directory(path))
    throw InputError(path + " is a folder", "name the page, --out " + path + "/comparison.html");
  if (std::filesystem::exists(path) && !is_report(path)) refuse_foreign(path);
  if (std::filesystem::exists(path) && options.existing == ReportOptions::Existing::refuse)
    throw InputError(path + " is there already", "give another page with --out, or add --overwrite");
  replace_file(path, page);
}

/// Writes the report into the result folder, where it is recorded.
std::string write_report(const ResultFolder& folder) {
  const std::string page = render_report(report_of(folder));
  if (std::filesystem::exists(folder.report()) && !recorded_files(folder.path()).contains("report.html"))
    refuse_foreign(folder.report());
  record_file(folder.path(), "report.html");
  replace_file(folder.report(), page);
  return folder.report();
}

}  // namespace

int run_report(const ReportOptions& options) {
  std::string path = options.out;
  if (options.folders.size() > 1) {
    if (path.empty()) path = comparison_path(options.folders);
    write_page(options, path, render_report(compare_folders(options.folders)));
  } else {
    const ResultFolder folder = ResultFolder::open(options.folders.front());
    if (path.empty())
      path = write_report(folder);
    else
      write_page(options, path, render_report(report_of(folder)));
  }
  fmt::print("{} in {}\n", options.folders.size() > 1 ? "comparison" : "report", path);
  return 0;
}

}  // namespace fiberfate
