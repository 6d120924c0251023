// Reads case files.
#include "keys/case_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "base/version.hpp"
#include "keys/case_checker.hpp"
#include "keys/material_presets.hpp"

namespace fiberfate {
namespace {

/// Keys that stand outside every table and belong to every study.
const std::vector<std::string> common_keys = {"study", "version"};

using Problems = std::vector<InputProblem>;

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == names.size() ? " or " : ", ", names[i]);
  return text;
}

const CaseKind& kind_of(const TomlDocument& document, const CaseKinds& kinds) {
  std::vector<std::string> names;
  for (const CaseKind* kind : kinds) names.push_back(kind->name);
  const TomlEntry* entry = document.find("study");
  if (entry == nullptr) {
    InputProblem problem;
    problem.file = document.name();
    problem.line = problem.column = 1;  // where it should stand
    problem.key = "study";
    problem.complaint = "not given, so nothing else can be checked";
    problem.remedy = fmt::format("add study = {} above the first [table]", listed(names));
    throw InputError({problem});
  }
  const auto* text = std::get_if<std::string>(&entry->value.data);
  const auto found = std::find_if(kinds.begin(), kinds.end(), [text](const CaseKind* kind) {
    return text != nullptr && kind->name == *text;
  });
  if (found != kinds.end()) return **found;
  InputProblem problem = problem_at(*entry);
  if (names.size() == 1) {
    problem.complaint = fmt::format("only cases of the study \"{}\" belong here", names.front());
    problem.remedy = "name one";
    throw InputError({problem});
  }
  problem.complaint = "there is no such study, so nothing else can be checked";
  const std::string nearest = text == nullptr ? std::string() : nearest_word(*text, names);
  problem.remedy = nearest.empty() ? "give " + listed(names) : fmt::format("did you mean \"{}\"?", nearest);
  throw InputError({problem});
}

void read_keys(const TomlDocument& document, const KeyTable& table, Problems& problems) {
  for (const Key& key : table.keys()) {
    const TomlEntry* entry = document.find(key.name);
    if (entry == nullptr) {
      if (key.notes.need != Need::required) continue;
      InputProblem problem = problem_at_key(document, key.name);
      problem.complaint = "not given";
      problem.remedy =
          fmt::format("add {} = {} under {}", key.leaf(), key.notes.example, table_heading(key.section()));
      problems.push_back(std::move(problem));
      continue;
    }
    for (const Complaint& complaint : key.read(entry->value)) {
      InputProblem problem = problem_at(*entry);
      if (complaint.at != nullptr) {
        problem.line = complaint.at->place.line;
        problem.column = complaint.at->place.column;
        problem.value = complaint.at->written;
      }
      problem.complaint = complaint.what;
      problem.remedy = complaint.remedy;
      problems.push_back(std::move(problem));
    }
  }
}

bool is_section(const KeyTable& table, const std::string& name) {
  return std::any_of(table.sections().begin(), table.sections().end(), [&name](const Section& section) {
    return section.name == name || section.name.starts_with(name + '.');
  });
}

/// Guesses which key is meant by one that does not exist.
std::string meant_key(const std::string& key, const CaseKind& kind, const KeyTable& table) {
  std::vector<std::string> names = common_keys;
  for (const Key& one : table.keys()) names.push_back(one.name);
  const std::string leaf = key.substr(key.rfind('.') + 1);
  for (const Key& one : table.keys())
    if (one.leaf() == leaf) return fmt::format("did you mean {}?", one.name);
  if (const std::string nearest = nearest_word(key, names); !nearest.empty())
    return fmt::format("did you mean {}?", nearest);
  for (const Key& one : table.keys())
    if (!nearest_word(leaf, {one.leaf()}).empty()) return fmt::format("did you mean {}?", one.name);
  return fmt::format("'fiberfate explain {}' lists the keys", kind.name);
}

InputProblem unknown_key(const TomlEntry& entry, const CaseKind& kind, const KeyTable& table) {
  InputProblem problem = problem_at(entry);
  problem.line = entry.place.line;
  problem.column = entry.place.column;
  if (table.is_repeated(entry.key)) {
    problem.complaint = "this is a table, and there may be several, not a key";
    problem.remedy = fmt::format("write [[{}]] and its keys below, once for each", entry.key);
  } else if (is_section(table, entry.key)) {
    problem.complaint = "this is a table, not a key";
    problem.remedy = fmt::format("write {} and its keys below", table_heading(entry.key));
  } else {
    problem.complaint = fmt::format("unknown key in study {}", kind.name);
    problem.remedy = meant_key(entry.key, kind, table);
  }
  return problem;
}

InputProblem unknown_table(const TomlTable& unknown, const CaseKind& kind, const KeyTable& table) {
  InputProblem problem{
      unknown.place.file, unknown.place.line, unknown.place.column, table_heading(unknown.name), "", "", ""};
  if (const Key* key = table.find(unknown.name)) {
    problem.complaint = "this is a key, not a table";
    problem.remedy = fmt::format("write {} = value under {}", key->leaf(), table_heading(key->section()));
    return problem;
  }
  if (table.is_repeated(unknown.name)) {
    problem.complaint = "there may be several of this table";
    problem.remedy = fmt::format("write [[{}]], with two brackets", unknown.name);
    return problem;
  }
  const std::vector<std::string> names = table.table_names();
  const std::string nearest = nearest_word(without_numbers(unknown.name), names);
  problem.complaint = fmt::format("unknown table in study {}", kind.name);
  // Repeated tables are named without a number there, and written in double brackets.
  const std::string heading =
      table_heading(table.is_repeated(nearest) ? KeyTable::repeated_name(nearest, 0) : nearest);
  problem.remedy = nearest.empty() ? fmt::format("the tables are {}", fmt::join(names, ", "))
                                   : fmt::format("did you mean {}?", heading);
  return problem;
}

/// Reports tables and keys that no study member reads; the keys of an unknown table are not reported again.
void find_unknown(const TomlDocument& document, const CaseKind& kind, const KeyTable& table,
                  Problems& problems) {
  std::vector<std::string> unknown_tables;
  const auto lies_in_unknown = [&unknown_tables](const std::string& name) {
    return std::any_of(unknown_tables.begin(), unknown_tables.end(),
                       [&name](const std::string& one) { return name.starts_with(one + '.'); });
  };
  for (const TomlTable& one : document.tables()) {
    if (is_section(table, one.name) || lies_in_unknown(one.name)) continue;
    problems.push_back(unknown_table(one, kind, table));
    unknown_tables.push_back(one.name);
  }
  for (const TomlEntry& entry : document.entries()) {
    const bool common = std::find(common_keys.begin(), common_keys.end(), entry.key) != common_keys.end();
    if (common || table.find(entry.key) != nullptr || lies_in_unknown(entry.key)) continue;
    problems.push_back(unknown_key(entry, kind, table));
  }
}

LoadedCase read_case(TomlDocument document, const std::string& folder, NamedFiles named_files,
                     const CaseKinds& kinds) {
  LoadedCase loaded;
  const CaseKind& kind = kind_of(document, kinds);
  loaded.kind = &kind;
  loaded.path = document.name();
  loaded.values = kind.make();
  KeyTable table(folder, document);
  kind.describe(table, loaded.values);
  add_preset(table, document);
  Problems problems;
  read_keys(document, table, problems);
  find_unknown(document, kind, table, problems);
  CaseChecker checker(document, std::move(problems), named_files);
  kind.validate(loaded.values, checker);
  if (!checker.is_sound()) {
    Problems all = checker.errors();
    std::stable_sort(all.begin(), all.end(), [](const InputProblem& a, const InputProblem& b) {
      // What stands nowhere in the file, because it is missing or from the command line, comes last.
      if ((a.line == 0) != (b.line == 0)) return b.line == 0;
      return a.line != b.line ? a.line < b.line : a.column < b.column;
    });
    for (InputProblem& one : all)
      if (one.file == loaded.path && one.line == 0) one.line = one.column = 1;  // stands nowhere yet
    throw InputError(std::move(all));
  }
  for (const InputProblem& warning : checker.warnings()) loaded.warnings.push_back(warning.message());
  return loaded;
}

std::string folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

void apply(const std::vector<std::string>& overrides, TomlDocument& document) {
  for (const std::string& assignment : overrides) document.override_with(assignment);
}

InputError unknown_variant(const std::string& name, const TomlDocument& variants) {
  std::vector<std::string> names;
  for (const TomlTable& table : variants.tables())
    if (table.name.find('.') == std::string::npos) names.push_back(table.name);
  const std::string nearest = nearest_word(name, names);
  return {fmt::format("{}: there is no variant {}", variants.name(), name),
          nearest.empty() ? fmt::format("the variants are {}", fmt::join(names, ", "))
                          : fmt::format("did you mean {}?", nearest)};
}

/// Takes the keys of the table [name], which stand there whole: "fibers.length" = "2 mm".
void apply_variant(const std::string& name, const TomlDocument& variants, TomlDocument& document) {
  const std::string prefix = name + '.';
  bool found = false;
  for (TomlEntry entry : variants.entries()) {
    if (!entry.key.starts_with(prefix)) continue;
    found = true;
    entry.key.erase(0, prefix.size());
    document.replace(std::move(entry));
  }
  if (!found) throw unknown_variant(name, variants);
}

void apply_variants(const std::vector<std::string>& names, const std::string& path, TomlDocument& document) {
  if (names.empty()) return;
  const std::string file = folder_of(path) + "/variants.toml";
  if (!std::filesystem::exists(file))
    throw InputError(fmt::format("{}: there is no variant {}", path, names.front()),
                     "variants are the tables of a file variants.toml beside the case; here is none");
  const TomlDocument variants = TomlDocument::read(file);
  for (const std::string& name : names) apply_variant(name, variants, document);
}

}  // namespace

LoadedCase load_case(const std::string& path, const CaseKinds& kinds, const CaseChanges& changes) {
  TomlDocument document = TomlDocument::read(path);
  apply_variants(changes.variants, path, document);
  apply(changes.overrides, document);
  return read_case(std::move(document), folder_of(path), NamedFiles::must_exist, kinds);
}

LoadedCase load_resolved_case(const std::string& path, const CaseKinds& kinds) {
  return read_case(TomlDocument::read(path), folder_of(path), NamedFiles::may_be_gone, kinds);
}

LoadedCase parse_case(const std::string& text, const std::string& name, const CaseKinds& kinds,
                      const std::vector<std::string>& overrides) {
  TomlDocument document = TomlDocument::parse(text, name);
  apply(overrides, document);
  return read_case(std::move(document), ".", NamedFiles::must_exist, kinds);
}

}  // namespace fiberfate
