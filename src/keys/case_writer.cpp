// Writes case files: resolved for the record, annotated for people.
#include <fmt/format.h>

#include <sstream>

#include "base/version.hpp"
#include "keys/case_file.hpp"
#include "keys/key_facts.hpp"
#include "keys/wrapped_text.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t line_width = 100;

std::string comment(const std::string& text) {
  return wrapped(text, "# ", line_width);
}

std::string explanation(const Key& key) {
  const KeyFacts facts = key_facts(key);
  std::string text = comment(key.notes.text);
  for (const NamedText& choice : key.choices)
    text += fmt::format("#   \"{}\": {}\n", choice.name, choice.meaning);
  std::string bounds;
  if (!facts.range.empty()) bounds = fmt::format("Range: {}. ", facts.range);
  if (!facts.source.empty()) bounds += fmt::format("Source: {}.", facts.source);
  return bounds.empty() ? text : text + comment(bounds);
}

/// What becomes of the examples of keys that a case usually gives, and this one does not.
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

/// Comments out the lines that are no comments yet.
std::string commented_out(const std::string& lines) {
  std::istringstream stream(lines);
  std::string text;
  for (std::string line; std::getline(stream, line);)
    text += (line.empty() || line.starts_with('#') ? "" : "# ") + line + '\n';
  return text;
}

std::string annotated(const CaseKind& kind, const CaseValues& values, Examples examples) {
  CaseValues copy = values, standard = kind.make();
  const auto repeats =
      examples == Examples::active ? KeyTable::Repeats::one_to_show : KeyTable::Repeats::of_case;
  KeyTable table(repeats), defaults(repeats);
  kind.describe(table, copy);
  kind.describe(defaults, standard);
  std::string text =
      comment(fmt::format("A case of the study {}: {}.", kind.name, kind.summary)) +
      comment(
          "Quantities carry their unit in quotes; a bare number is in SI units. Lines that begin "
          "with # are comments: defaults, and keys that are not given.") +
      fmt::format("study = \"{}\"\n", kind.name);
  for (const Section& section : table.sections()) {
    std::string lines = fmt::format("\n{}{}\n", comment(section.text), table_heading(section.name));
    for (const Key& key : table.keys()) {
      if (key.section() != section.name) continue;
      const Key* same = defaults.find(key.name);
      lines += '\n' + annotated_key(key, same == nullptr ? "" : same->write(NumberStyle::friendly), examples);
    }
    const bool shown_only = examples == Examples::active && without_numbers(section.name) != section.name;
    text += shown_only ? commented_out(lines) : lines;
  }
  return text;
}

}  // namespace

std::string resolved_case(const CaseKind& kind, const CaseValues& values) {
  CaseValues copy = values;
  KeyTable table;
  kind.describe(table, copy);
  std::string text = fmt::format(
      "# The resolved case: every key, in SI units.\nstudy = \"{}\"\nversion = \"{}\"\n", kind.name, version);
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
    text += fmt::format("\n{}\n{}", table_heading(section.name), keys);
  }
  return text;
}

std::string annotated_case(const CaseKind& kind, const CaseValues& values) {
  return annotated(kind, values, Examples::commented);
}

std::string case_template(const CaseKind& kind) {
  return annotated(kind, kind.make(), Examples::active);
}

}  // namespace fiberfate
