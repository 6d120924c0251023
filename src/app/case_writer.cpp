// Writes case files: resolved for the record, annotated for people.
#include <fmt/format.h>

#include <sstream>

#include "app/case_file.hpp"
#include "app/key_facts.hpp"
#include "base/version.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t line_width = 100;

/// Breaks a text into comment lines.
std::string comment(const std::string& text) {
  std::istringstream words(text);
  std::string lines, line = "#";
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > line_width) {
      lines += line + '\n';
      line = "#";
    }
    line += ' ' + word;
  }
  return lines + line + '\n';
}

std::string explanation(const Key& key) {
  const KeyFacts facts = key_facts(key);
  std::string text = comment(key.notes.text);
  for (const auto& [name, meaning] : key.choices) text += fmt::format("#   \"{}\": {}\n", name, meaning);
  std::string bounds;
  if (!facts.range.empty()) bounds = fmt::format("Range: {}. ", facts.range);
  if (!facts.source.empty()) bounds += fmt::format("Source: {}.", facts.source);
  return bounds.empty() ? text : text + comment(bounds);
}

/// Says what becomes of the examples of keys that a case usually gives, and this one does not.
enum class Examples { active, commented };

/// Writes one key of an annotated file: commented out where it is at its default.
std::string annotated_key(const Key& key, const std::string& standard, Examples examples) {
  const std::string value = key.write(NumberStyle::friendly);
  const bool at_default = value == standard && !value.empty();
  const bool active = examples == Examples::active && key.notes.need != Need::optional;
  std::string text = explanation(key);
  if (value.empty())
    text += fmt::format("{}{} ={}{}\n", active ? "" : "# ", key.leaf(), key.notes.example.empty() ? "" : " ",
                        key.notes.example);
  else
    text += fmt::format("{}{} = {}\n", at_default ? "# " : "", key.leaf(), value);
  return text;
}

std::string annotated(const Study& study, const CaseValues& values, Examples examples) {
  CaseValues copy = values, standard = study.make();
  KeyTable table, defaults;
  study.describe(table, copy);
  study.describe(defaults, standard);
  std::string text =
      comment(fmt::format("A case of the study {}: {}.", study.name, study.summary)) +
      comment(
          "Quantities carry their unit in quotes; a bare number is in SI units. Lines that begin "
          "with # are comments: defaults, and keys that are not given.") +
      fmt::format("study = \"{}\"\n", study.name);
  for (const Section& section : table.sections()) {
    text += fmt::format("\n{}[{}]\n", comment(section.text), section.name);
    for (std::size_t i = 0; i < table.keys().size(); ++i) {
      const Key& key = table.keys()[i];
      if (key.section() == section.name)
        text += '\n' + annotated_key(key, defaults.keys()[i].write(NumberStyle::friendly), examples);
    }
  }
  return text;
}

}  // namespace

std::string resolved_case(const Study& study, const CaseValues& values) {
  CaseValues copy = values;
  KeyTable table;
  study.describe(table, copy);
  std::string text =
      fmt::format("# The resolved case: every key, in SI units.\nstudy = \"{}\"\nversion = \"{}\"\n",
                  study.name, version);
  for (const Section& section : table.sections()) {
    std::string keys;
    for (const Key& key : table.keys()) {
      if (key.section() != section.name) continue;
      const std::string value = key.write(NumberStyle::si);
      if (value.empty())
        keys += fmt::format("# {} is not given\n", key.leaf());
      else
        keys += fmt::format("{} = {}{}\n", key.leaf(), value,
                            key.notes.unit == "1" ? std::string() : "  # " + key.notes.unit);
    }
    text += fmt::format("\n[{}]\n{}", section.name, keys);
  }
  return text;
}

std::string annotated_case(const Study& study, const CaseValues& values) {
  return annotated(study, values, Examples::commented);
}

std::string case_template(const Study& study) {
  return annotated(study, study.make(), Examples::active);
}

}  // namespace fiberfate
