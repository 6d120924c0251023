// Keys that name a law of a registry (base/law_text.hpp): a new row is a new choice.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/law_choice.hpp"
#include "keys/case_checker.hpp"
#include "keys/key_rows.hpp"

namespace fiberfate {

/// Adds a key that holds the name of a law; choices, their meanings and sources are those of the registry.
template <class Row>
void describe_law_name(KeyTable& table, const std::string& key, std::string& member,
                       const std::vector<Row>& laws, KeyNotes notes) {
  std::vector<Choice<std::string>> choices;
  for (const Row& law : laws)
    choices.push_back({law.text.name, law.text.name, law.text.meaning, law.text.source});
  table.choice(key, member, choices, std::move(notes));
}

/// The key that holds the name of a law, as a row.
template <class Group, class Row>
[[nodiscard]] KeyRow<Group> law_key(const char* leaf, std::string Group::*member,
                                    const std::vector<Row>& laws, const char* text) {
  return {leaf, [member, &laws, text](KeyTable& table, const std::string& name, Group& group) {
            describe_law_name(table, name, group.*member, laws, {.text = text});
          }};
}

/// Writes which laws read a constant: contact.law = "exponential" or "hertz".
template <class Row>
[[nodiscard]] std::string laws_that_read(const std::string& key, const std::vector<Row>& laws,
                                         std::string_view constant) {
  std::vector<std::string> names;
  for (const Row& law : laws) {
    if (reads_constant(law.text, constant)) names.push_back(fmt::format("\"{}\"", law.text.name));
  }
  return fmt::format("{} = {}", key, fmt::join(names, " or "));
}

/// Warns of constants that a case gives although its law, the one that the key names, does not read them.
template <class Row>
void warn_of_unread_constants(const std::string& key, const std::vector<Row>& laws, std::string_view chosen,
                              CaseChecker& checker) {
  if (!checker.is_sound(key)) return;
  const LawText& reader = law_named(laws, chosen, "law").text;
  const std::string section = key.substr(0, key.find('.') + 1);
  std::vector<std::string_view> seen;
  for (const Row& law : laws) {
    for (const char* constant : law.text.constants) {
      if (constant == nullptr || reads_constant(reader, constant)) continue;
      if (std::ranges::find(seen, std::string_view(constant)) != seen.end()) continue;
      seen.emplace_back(constant);
      checker.warn_unused({section + constant}, laws_that_read(key, laws, constant));
    }
  }
}

}  // namespace fiberfate
