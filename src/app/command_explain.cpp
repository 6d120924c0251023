// Explains keys in the terminal.
#include "app/command_explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "app/study_registry.hpp"
#include "base/error.hpp"
#include "keys/key_facts.hpp"
#include "keys/wrapped_text.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t text_width = 96;
constexpr std::size_t choice_indent = 19;  // of what a choice means

std::string indented(const std::string& text, std::size_t indent) {
  return wrapped(text, std::string(indent, ' '), text_width);
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

std::string explained(const Key& key) {
  const KeyFacts facts = key_facts(key);
  std::string text = indented(key.notes.text, 2);
  for (const NamedText& choice : key.choices) {
    const std::string source = choice.source.empty() ? "" : fmt::format(" ({})", choice.source);
    const std::string meaning = indented(choice.meaning + source, choice_indent);
    text += fmt::format("    {:<{}} {}", '"' + choice.name + '"', choice_indent - 5,
                        meaning.substr(choice_indent));
  }
  const std::pair<const char*, std::string> lines[] = {{"kind", facts.kind},        {"unit", facts.unit},
                                                       {"default", facts.standard}, {"range", facts.range},
                                                       {"example", facts.example},  {"source", facts.source}};
  for (const auto& [name, value] : lines)
    if (!value.empty()) text += fmt::format("  {:<8} {}\n", name, value);
  return text;
}

std::string explained(const StudyKeys& keys, const Section& section) {
  std::string text = indented(section.text, 2);
  std::size_t width = 0;
  for (const Key& key : keys.table.keys()) width = std::max(width, key.leaf().size());
  for (const Key& key : keys.table.keys()) {
    if (key.section() != section.name) continue;
    text +=
        fmt::format("  {:<{}}{}", key.leaf(), width, indented(key.notes.text, width + 4).substr(width + 2));
  }
  return text;
}

void explain_study(const Study& study) {
  const StudyKeys keys(study);
  fmt::print("study = \"{}\": {}\n", study.name, study.summary);
  for (const Section& section : keys.table.sections()) {
    fmt::print("\n{} ({})\n{}", table_heading(section.name), study.name, explained(keys, section));
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

/// What a topic means, in the studies that agree on it.
struct Explanation {
  std::string name;
  std::string text;
  std::vector<std::string> studies;
};

void add(std::vector<Explanation>& all, const std::string& name, const std::string& text,
         const std::string& study) {
  const auto same =
      std::ranges::find_if(all, [&](const Explanation& one) { return one.name == name && one.text == text; });
  if (same == all.end())
    all.push_back({name, text, {study}});
  else if (same->studies.back() != study)
    same->studies.push_back(study);
}

/// Explains a table, a key, or the last part of a key's name in all studies.
std::vector<Explanation> explanations_of(const std::string& topic) {
  std::vector<Explanation> all;
  for (const Study& study : studies()) {
    const StudyKeys keys(study);
    for (const Section& section : keys.table.sections())
      if (without_numbers(section.name) == topic)
        add(all, table_heading(section.name), explained(keys, section), study.name);
    for (const Key& key : keys.table.keys())
      if (without_numbers(key.name) == topic || key.leaf() == topic)
        add(all, without_numbers(key.name), explained(key), study.name);
  }
  return all;
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
  const std::vector<Explanation> all = explanations_of(options.topic);
  if (all.empty()) refuse_topic(options.topic);
  for (const Explanation& one : all)
    fmt::print("{}{} ({})\n{}", &one == &all.front() ? "" : "\n", one.name, fmt::join(one.studies, ", "),
               one.text);
  return 0;
}

}  // namespace fiberfate
