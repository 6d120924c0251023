// Keys as rows of a table: one row binds one key to one member of a group of choices.
#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "keys/key_table.hpp"

namespace fiberfate {

/// Whether a case may leave a key out, and what a template shows in its place.
struct Given {
  Need need = Need::optional;
  const char* example = "";
};
/// Every case gives it.
[[nodiscard]] constexpr Given required(const char* example) {
  return {Need::required, example};
}
/// Most cases give it.
[[nodiscard]] constexpr Given usual(const char* example) {
  return {Need::usual, example};
}
/// It has no default; a template shows the example, commented out.
[[nodiscard]] constexpr Given optional(const char* example = "") {
  return {Need::optional, example};
}

template <class Enum>
using Choices = std::vector<Choice<Enum>>;

inline void add_quantity(KeyTable& table, const std::string& key, double& member, KeyNotes notes) {
  table.quantity(key, member, std::move(notes));
}
inline void add_quantity(KeyTable& table, const std::string& key, std::optional<double>& member,
                         KeyNotes notes) {
  table.quantity(key, member, std::move(notes));
}
inline void add_quantity(KeyTable& table, const std::string& key, std::vector<double>& member,
                         KeyNotes notes) {
  table.quantities(key, member, std::move(notes));
}
template <std::integral Integer>
void add_quantity(KeyTable& table, const std::string& key, Integer& member, KeyNotes notes) {
  table.count(key, member, std::move(notes));
}
inline void add_quantity(KeyTable& table, const std::string& key, std::optional<std::int64_t>& member,
                         KeyNotes notes) {
  table.count(key, member, std::move(notes));
}

/// One key of a group, under its leaf: "rate" of the group "flow" is the key flow.rate and the member rate.
template <class Group>
class KeyRow {
 public:
  /// A number with its unit and range: double, optional, list of doubles or whole number, after the member.
  template <class Member>
  KeyRow(const char* leaf, Member Group::*member, Units units, Range range, Given given, const char* source,
         const char* text)
      : leaf_(leaf), add_([=](KeyTable& table, const std::string& key, Group& group) {
          add_quantity(table, key, group.*member,
                       {text, units.si, units.friendly, range, given.need, given.example, source});
        }) {}
  /// One of several names.
  template <class Enum>
  KeyRow(const char* leaf, Enum Group::*member, Choices<Enum> choices, const char* source, const char* text)
      : leaf_(leaf),
        add_([=, all = std::move(choices)](KeyTable& table, const std::string& key, Group& group) {
          table.choice(key, group.*member, all, {.text = text, .source = source});
        }) {}
  /// Any other kind of value.
  KeyRow(const char* leaf, std::function<void(KeyTable&, const std::string& key, Group&)> add)
      : leaf_(leaf), add_(std::move(add)) {}

  void add(KeyTable& table, const std::string& section, Group& group) const {
    add_(table, section + '.' + leaf_, group);
  }

 private:
  std::string leaf_;
  std::function<void(KeyTable&, const std::string&, Group&)> add_;
};

/// The keys of one TOML table, for the members of one struct.
template <class Group>
struct KeyGroup {
  std::string section;  ///< "flow"
  std::string text;     ///< what the table is for
  std::vector<KeyRow<Group>> rows;
};

/// Adds the heading and every key of a group.
template <class Group>
void describe(KeyTable& table, const KeyGroup<Group>& keys, Group& group) {
  table.section(keys.section, keys.text);
  for (const KeyRow<Group>& row : keys.rows) row.add(table, keys.section, group);
}

}  // namespace fiberfate
