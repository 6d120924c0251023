// Documents every key of every study in Markdown (docs/guide/case_keys.md).
#include <fmt/format.h>

#include "app/command_explain.hpp"
#include "app/study_registry.hpp"
#include "keys/key_facts.hpp"

namespace fiberfate {
namespace {

/// Keeps a text inside a cell of a table.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '|') escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string code(const std::string& text) {
  return text.empty() ? text : fmt::format("`{}`", text);
}

std::string key_row(const Key& key) {
  const KeyFacts facts = key_facts(key);
  std::string text = key.notes.text;
  for (const NamedText& choice : key.choices) {
    text += fmt::format("<br>`\"{}\"`: {}", choice.name, choice.meaning);
    if (!choice.source.empty()) text += fmt::format(" ({})", choice.source);
  }
  if (!facts.source.empty()) text += fmt::format("<br>Source: {}", facts.source);
  const bool none = facts.standard.starts_with("none");
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", key.leaf(), facts.unit,
                     none ? facts.standard : code(facts.standard), facts.range, cell(text));
}

}  // namespace

std::string key_reference() {
  std::string text =
      "# Keys of case files\n\n"
      "Written by `fiberfate explain --markdown` from the table that also reads case files; do not edit.\n"
      "Quantities carry their unit in quotes, `\"19 um\"`; a bare number is in the SI unit named first.\n"
      "Every case begins with `study = \"NAME\"`.\n";
  for (const Study& study : studies()) {
    CaseValues values = study.make();
    KeyTable table(KeyTable::Repeats::one_to_show);
    study.describe(table, values);
    text += fmt::format("\n## {}\n\n`study = \"{}\"`: {}.\n", study.name, study.name, study.summary);
    for (const Section& section : table.sections()) {
      text +=
          fmt::format("\n### {}\n\n{}\n\n| key | unit | default | range | meaning |\n|---|---|---|---|---|\n",
                      table_heading(section.name), section.text);
      for (const Key& key : table.keys())
        if (key.section() == section.name) text += key_row(key);
    }
  }
  return text;
}

}  // namespace fiberfate
