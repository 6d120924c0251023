// Reads the results that are compared.
#include "app/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>

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

/// Reads the lines of a resolved case: "key = value  # unit" below "[table]".
std::vector<ResolvedKey> keys_of(const LoadedCase& loaded) {
  std::vector<ResolvedKey> keys;
  std::istringstream text(resolved_case(*loaded.kind, loaded.values));
  std::string line, table;
  while (std::getline(text, line)) {
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[') {
      table = line.substr(1, line.find(']') - 1) + ".";
      continue;
    }
    const std::size_t equals = line.find(" = "), unit = line.rfind("  # ");
    if (equals == std::string::npos) continue;
    ResolvedKey key{table + line.substr(0, equals), line.substr(equals + 3)};
    if (unit != std::string::npos) {
      key.value = line.substr(equals + 3, unit - equals - 3);
      key.unit = line.substr(unit + 4);
    }
    if (key.name != "study" && key.name != "version") keys.push_back(std::move(key));
  }
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

}  // namespace

ReportDocument report_of(const ResultFolder& folder) {
  const LoadedCase loaded = load_resolved_case(folder.resolved_case(), case_kinds());
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

ReportDocument compare_folders(const std::vector<std::string>& folders) {
  std::vector<fs::path> paths;
  for (const std::string& folder : folders) paths.push_back(whole(folder));
  require_different(paths);
  const std::vector<std::string> names = names_of(paths);
  std::vector<ComparedRun> runs;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const ResultFolder folder = ResultFolder::open(folders[i]);
    const LoadedCase loaded = load_resolved_case(folder.resolved_case(), case_kinds());
    if (!runs.empty() && loaded.kind->name != runs.front().document.study)
      throw InputError(fmt::format("{} holds a result of the study {}, {} one of {}", folders[0],
                                   runs.front().document.study, folders[i], loaded.kind->name),
                       "compare results of one study");
    runs.push_back({names[i], report_of(folder), keys_of(loaded)});
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
