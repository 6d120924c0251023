// Explains keys in the terminal.
#include "app/command_explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <vector>

#include "app/study_registry.hpp"
#include "base/error.hpp"
#include "keys/key_facts.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t text_width = 96;

/// Wraps a text into lines that begin with `indent` spaces.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  const std::string margin(indent, ' ');
  std::string lines, line = margin;
  for (std::string word; words >> word;) {
    if (line.size() > indent && line.size() + 1 + word.size() > text_width) {
      lines += line + '\n';
      line = margin;
    }
    line += (line.size() > indent ? " " : "") + word;
  }
  return lines + line + '\n';
}

/// Describes a study's keys together with the defaults that they are bound to.
struct StudyKeys {
  explicit StudyKeys(const Study& one) : study(one), values(one.make()) { study.describe(table, values); }
  StudyKeys(const StudyKeys&) = delete;
  StudyKeys& operator=(const StudyKeys&) = delete;

  const Study& study;
  CaseValues values;
  KeyTable table{KeyTable::Repeats::one_to_show};
};

void explain_key(const Key& key, const std::string& study) {
  const KeyFacts facts = key_facts(key);
  fmt::print("{} ({})\n{}", without_numbers(key.name), study, wrapped(key.notes.text, 2));
  for (const auto& [name, meaning] : key.choices) fmt::print("    {:<14} {}\n", '"' + name + '"', meaning);
  const std::pair<const char*, std::string> lines[] = {{"kind", facts.kind},        {"unit", facts.unit},
                                                       {"default", facts.standard}, {"range", facts.range},
                                                       {"example", facts.example},  {"source", facts.source}};
  for (const auto& [name, value] : lines)
    if (!value.empty()) fmt::print("  {:<8} {}\n", name, value);
}

void explain_section(const StudyKeys& keys, const Section& section) {
  fmt::print("{} ({})\n{}", table_heading(section.name), keys.study.name, wrapped(section.text, 2));
  std::size_t width = 0;
  for (const Key& key : keys.table.keys()) width = std::max(width, key.leaf().size());
  for (const Key& key : keys.table.keys()) {
    if (key.section() != section.name) continue;
    const std::string text = wrapped(key.notes.text, width + 4);
    fmt::print("  {:<{}}{}", key.leaf(), width, text.substr(width + 2));
  }
}

void explain_study(const Study& study) {
  const StudyKeys keys(study);
  fmt::print("study = \"{}\": {}\n", study.name, study.summary);
  for (const Section& section : keys.table.sections()) {
    fmt::print("\n");
    explain_section(keys, section);
  }
}

void explain_overview() {
  fmt::print("The studies:\n");
  for (const Study& study : studies()) fmt::print("  {:<12} {}\n", study.name, study.summary);
  fmt::print(
      "\nfiberfate explain STUDY lists the keys of a study, fiberfate explain KEY tells all about a key:\n"
      "  fiberfate explain shear_cell\n  fiberfate explain fibers.rod_length\n");
}

[[noreturn]] void refuse_topic(const std::string& topic) {
  std::vector<std::string> names = study_names();
  for (const Study& study : studies()) {
    const StudyKeys keys(study);
    for (const Section& section : keys.table.sections()) names.push_back(without_numbers(section.name));
    for (const Key& key : keys.table.keys()) names.push_back(without_numbers(key.name));
    for (const Key& key : keys.table.keys()) names.push_back(key.leaf());
  }
  // Hardly anybody misses the first letter: a word with another one is another word.
  std::erase_if(names, [&topic](const std::string& name) { return !name.starts_with(topic.front()); });
  const std::string nearest = nearest_word(topic, names);
  throw InputError(
      fmt::format("there is no study, table or key '{}'", topic),
      nearest.empty() ? "'fiberfate explain' lists the studies" : fmt::format("did you mean '{}'?", nearest));
}

/// Explains a topic in one study; tells whether it is known there.
bool explain_in(const Study& study, const std::string& topic) {
  const StudyKeys keys(study);
  bool known = false;
  for (const Section& section : keys.table.sections()) {
    if (without_numbers(section.name) != topic) continue;
    explain_section(keys, section);
    known = true;
  }
  for (const Key& key : keys.table.keys()) {
    if (without_numbers(key.name) != topic && key.leaf() != topic) continue;
    if (known) fmt::print("\n");
    explain_key(key, study.name);
    known = true;
  }
  return known;
}

}  // namespace

int run_explain(const ExplainOptions& options) {
  if (options.layout == ExplainLayout::markdown) {
    fmt::print("{}", key_reference());
    return 0;
  }
  if (options.topic.empty()) {
    explain_overview();
    return 0;
  }
  if (const Study* study = find_study(options.topic)) {
    explain_study(*study);
    return 0;
  }
  // Studies share most of their tables; the first that knows the topic explains it for all.
  for (const Study& study : studies())
    if (explain_in(study, options.topic)) return 0;
  refuse_topic(options.topic);
}

}  // namespace fiberfate
