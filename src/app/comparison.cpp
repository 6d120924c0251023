// Reads the results that are compared.
#include "app/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/study_registry.hpp"
#include "base/error.hpp"
#include "base/version.hpp"
#include "keys/case_file.hpp"
#include "results/report_comparison.hpp"
#include "results/summary.hpp"

namespace fiberfate {
namespace {

namespace fs = std::filesystem;

/// The path without a slash at its end, also of ".".
fs::path whole(const std::string& folder) {
  const fs::path path = fs::weakly_canonical(folder);
  return path.has_filename() ? path : path.parent_path();
}

/// Lists the keys that a case gives, as case.resolved.toml has them.
std::vector<ResolvedKey> keys_of(const LoadedCase& loaded) {
  CaseValues values = loaded.values;
  KeyTable table;
  loaded.kind->describe(table, values);
  std::vector<ResolvedKey> keys;
  for (const Key& key : table.keys())
    if (std::string value = key.write(NumberStyle::si); !value.empty())
      keys.push_back({key.name, std::move(value), key.notes.unit == "1" ? "" : key.notes.unit});
  return keys;
}

/// The folders' names, with so many of the folders above as tell them apart.
std::vector<std::string> names_of(const std::vector<fs::path>& folders) {
  const auto named = [&folders](int above) {
    std::vector<std::string> names;
    for (const fs::path& folder : folders) {
      fs::path name = folder.filename(), rest = folder.parent_path();
      for (int k = 0; k < above && rest.has_filename(); ++k, rest = rest.parent_path())
        name = rest.filename() / name;
      names.push_back(name.string());
    }
    return names;
  };
  constexpr int most_above = 8;
  for (int above = 0; above < most_above; ++above) {
    std::vector<std::string> names = named(above), sorted = names;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end()) return names;
  }
  return named(most_above);
}

void require_different(const std::vector<fs::path>& folders) {
  for (std::size_t i = 0; i < folders.size(); ++i)
    if (std::find(folders.begin(), folders.begin() + static_cast<std::ptrdiff_t>(i), folders[i]) !=
        folders.begin() + static_cast<std::ptrdiff_t>(i))
      throw InputError(fmt::format("{} is given twice", folders[i].string()), "name every folder once");
}

LoadedCase case_of(const ResultFolder& folder) {
  return load_resolved_case(folder.resolved_case(), case_kinds());
}

ReportDocument report_of(const LoadedCase& loaded, const ResultFolder& folder) {
  if (!fs::exists(folder.summary()) && !fs::exists(folder.frames()))
    throw InputError(folder.path() + " has nothing to show: the run ended before its first result",
                     "continue it with 'fiberfate resume', or run the case again");
  ReportDocument document = study_of(loaded).report(loaded.values, folder);
  document.case_name = whole(folder.path()).filename().string();
  document.study = loaded.kind->name;
  document.version = version;
  const std::optional<SummaryFile> summary = read_summary(folder.summary());
  document.stop_reason = summary ? summary->text("stop_reason") : "unfinished";
  return document;
}

}  // namespace

ReportDocument report_of(const ResultFolder& folder) {
  return report_of(case_of(folder), folder);
}

ReportDocument compare_folders(const std::vector<std::string>& folders) {
  std::vector<fs::path> paths;
  for (const std::string& folder : folders) paths.push_back(whole(folder));
  require_different(paths);
  const std::vector<std::string> names = names_of(paths);
  std::vector<ComparedRun> runs;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const ResultFolder folder = ResultFolder::open(folders[i]);
    const LoadedCase loaded = case_of(folder);
    if (!runs.empty() && loaded.kind->name != runs.front().document.study)
      throw InputError(fmt::format("{} holds a result of the study {}, {} one of {}", folders[0],
                                   runs.front().document.study, folders[i], loaded.kind->name),
                       "compare results of one study");
    runs.push_back({names[i], report_of(loaded, folder), keys_of(loaded)});
  }
  return compare_reports(runs);
}

std::string comparison_path(const std::vector<std::string>& folders) {
  const fs::path above = whole(folders.front()).parent_path();
  const bool together = std::ranges::all_of(
      folders, [&above](const std::string& folder) { return whole(folder).parent_path() == above; });
  return together ? (fs::path(folders.front()) / ".." / "comparison.html").lexically_normal().string()
                  : "comparison.html";
}

}  // namespace fiberfate
