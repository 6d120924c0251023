// Keys as rows of a table: one row binds one key to one member of a group of choices.
#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "keys/key_table.hpp"
#include "keys/text_keys.hpp"

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

/// One key of a group, under its leaf: "rate" of the group "flow" is the key flow.rate.
template <class Group>
struct KeyRow {
  const char* leaf;
  std::function<void(KeyTable&, const std::string& key, Group&)> add;
};
template <class Group>
using KeyRows = std::vector<KeyRow<Group>>;

/// The keys of one TOML table, for the members of one struct.
template <class Group>
struct KeyGroup {
  std::string section;  ///< "flow"
  std::string text;     ///< what the table is for
  KeyRows<Group> rows;
};

/// Adds the keys of some rows to the table `section`.
template <class Group>
void describe(KeyTable& table, const std::string& section, const KeyRows<Group>& rows,
              std::type_identity_t<Group>& group) {
  for (const KeyRow<Group>& row : rows) row.add(table, section + '.' + row.leaf, group);
}
/// Adds the heading and every key of a group.
template <class Group>
void describe(KeyTable& table, const KeyGroup<Group>& keys, std::type_identity_t<Group>& group) {
  table.section(keys.section, keys.text);
  describe(table, keys.section, keys.rows, group);
}

/// Lets rows of one struct describe another that has or is one: `part` finds it.
template <class Group, class Part, class Find>
[[nodiscard]] KeyRows<Group> rows_within(const KeyRows<Part>& rows, const Find& part) {
  KeyRows<Group> lifted;
  for (const KeyRow<Part>& row : rows)
    lifted.push_back({row.leaf, [row, part](KeyTable& table, const std::string& key, Group& group) {
                        row.add(table, key, part(group));
                      }});
  return lifted;
}
/// The rows of a member whose keys stand in the table of the group itself.
template <class Group, class Part>
[[nodiscard]] KeyRows<Group> rows_of(Part Group::*member, const KeyRows<std::type_identity_t<Part>>& rows) {
  return rows_within<Group, Part>(rows, [member](Group& group) -> Part& { return group.*member; });
}
/// The rows of a base class.
template <class Group, class Base>
[[nodiscard]] KeyRows<Group> rows_of_base(const KeyRows<Base>& rows) {
  return rows_within<Group, Base>(rows, [](Group& group) -> Base& { return group; });
}
/// Several lists of rows as one.
template <class Group>
[[nodiscard]] KeyRows<Group> joined(const std::vector<KeyRows<Group>>& lists) {
  KeyRows<Group> all;
  for (const KeyRows<Group>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

inline void add_number(KeyTable& table, const std::string& key, double& member, KeyNotes notes) {
  table.quantity(key, member, std::move(notes));
}
inline void add_number(KeyTable& table, const std::string& key, std::optional<double>& member,
                       KeyNotes notes) {
  table.quantity(key, member, std::move(notes));
}
inline void add_number(KeyTable& table, const std::string& key, std::vector<double>& member, KeyNotes notes) {
  table.quantities(key, member, std::move(notes));
}
template <std::integral Integer>
void add_number(KeyTable& table, const std::string& key, Integer& member, KeyNotes notes) {
  table.count(key, member, std::move(notes));
}
inline void add_number(KeyTable& table, const std::string& key, std::optional<std::int64_t>& member,
                       KeyNotes notes) {
  table.count(key, member, std::move(notes));
}

/// A number with its unit and range: double, optional, list of doubles or whole number, after the member.
template <class Group, class Member>
[[nodiscard]] KeyRow<Group> key(const char* leaf, Member Group::*member, Units units, Range range,
                                std::string text, Given given = {}, const char* source = "") {
  const KeyNotes notes = {std::move(text), std::move(units.si), std::move(units.friendly),
                          range,           given.need,          given.example,
                          source};
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            add_number(table, name, group.*member, notes);
          }};
}
/// One of several values of an enum.
template <class Enum>
using Choices = std::vector<Choice<Enum>>;
template <class Group, class Enum>
requires std::is_enum_v<Enum>
[[nodiscard]] KeyRow<Group> key(const char* leaf, Enum Group::*member,
                                std::type_identity_t<Choices<Enum>> choices, std::string text,
                                const char* source = "") {
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            table.choice(name, group.*member, choices, {.text = text, .source = source});
          }};
}
/// The name of a value among its choices; empty where it is none of them.
template <class Enum>
[[nodiscard]] std::string name_of(const Choices<Enum>& choices, Enum value) {
  for (const Choice<Enum>& one : choices)
    if (one.value == value) return one.name;
  return {};
}
/// One of several names; an empty one is "not given".
template <class Group>
[[nodiscard]] KeyRow<Group> name_key(const char* leaf, std::string Group::*member, const NamedTexts& names,
                                     const char* text) {
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            describe_name(table, name, group.*member, names, {.text = text});
          }};
}
/// A text; `kind` says what it is ("column").
template <class Group>
[[nodiscard]] KeyRow<Group> text_key(const char* leaf, std::string Group::*member, const char* kind,
                                     const char* text, Given given = {}, const char* source = "") {
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            describe_text(table, name, group.*member, kind,
                          {.text = text, .need = given.need, .example = given.example, .source = source});
          }};
}
/// A list of texts.
template <class Group>
[[nodiscard]] KeyRow<Group> texts_key(const char* leaf, Texts Group::*member, const char* text,
                                      Given given = {}) {
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            describe_texts(table, name, group.*member,
                           {.text = text, .need = given.need, .example = given.example});
          }};
}
/// The path of a file.
template <class Group>
[[nodiscard]] KeyRow<Group> file_key(const char* leaf, std::string Group::*member, const char* text,
                                     Given given = {}) {
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            table.file(name, group.*member, {.text = text, .need = given.need, .example = given.example});
          }};
}
/// Rows of quantities, in place or in a file.
template <class Group>
[[nodiscard]] KeyRow<Group> rows_key(const char* leaf, std::vector<std::vector<double>> Group::*member,
                                     const std::vector<Column>& columns, const char* text, Given given = {},
                                     const char* source = "") {
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            table.rows(name, group.*member, columns,
                       {.text = text, .need = given.need, .example = given.example, .source = source});
          }};
}
/// Three quantities.
template <class Group>
[[nodiscard]] KeyRow<Group> vector_key(const char* leaf, std::optional<Vec3> Group::*member,
                                       KeyTable::Cubic cubic, KeyNotes notes) {
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            table.vector(name, group.*member, cubic, notes);
          }};
}
/// An orientation tensor.
template <class Group>
[[nodiscard]] KeyRow<Group> orientation_key(const char* leaf, Mat3 Group::*member, const char* text,
                                            Given given = {}, const char* source = "") {
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            table.orientation(name, group.*member,
                              {.text = text, .need = given.need, .example = given.example, .source = source});
          }};
}

}  // namespace fiberfate
