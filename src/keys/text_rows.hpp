// Reads and writes keys that hold rows of names and quantities, such as ["G1", "10 mm", "20 mm"].
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "keys/key_rows.hpp"

namespace fiberfate {

/// Gives the items of a row as texts; numbers as they are written.
class RowTexts {
 public:
  explicit RowTexts(const std::vector<TomlValue>& row) : row_(row) {}
  [[nodiscard]] std::size_t count() const { return row_.size(); }
  [[nodiscard]] std::string text(std::size_t item) const;

 private:
  const std::vector<TomlValue>& row_;
};

/// How one kind of row is kept.
struct RowKeeper {
  /// Takes a row, or tells what is wrong with it.
  std::function<std::optional<Complaint>(const std::vector<TomlValue>&)> append;
  std::function<void()> clear;
  std::function<std::vector<std::string>(NumberStyle)> write;  ///< each row as TOML
};

/// Adds a key that holds a list of such rows.
void describe_text_rows(KeyTable& table, const std::string& key, KeyNotes notes, RowKeeper keeper);

/// How rows of one kind become items, and items rows.
template <class Item>
struct RowForm {
  /// Makes an item of a row, or tells what is wrong with it; `before` are those of the rows before.
  std::function<Reading<Item>(const std::vector<TomlValue>& row, const std::vector<Item>& before)> read;
  std::function<std::vector<std::string>(const Item&, NumberStyle)> write;  ///< as TOML
};

/// A key that holds such rows, as a row of keys.
template <class Group, class Item>
[[nodiscard]] KeyRow<Group> items_key(const char* leaf, std::vector<Item> Group::*member,
                                      const std::type_identity_t<RowForm<Item>>& form, const char* text,
                                      Given given = {}, const char* source = "") {
  return {leaf, [=](KeyTable& table, const std::string& name, Group& group) {
            std::vector<Item>& items = group.*member;
            const auto append = [&items,
                                 form](const std::vector<TomlValue>& row) -> std::optional<Complaint> {
              const Reading<Item> item = form.read(row, items);
              if (const auto* complaint = std::get_if<Complaint>(&item)) return *complaint;
              items.push_back(std::get<Item>(item));
              return std::nullopt;
            };
            const auto write = [&items, form](NumberStyle style) {
              std::vector<std::string> rows;
              for (const Item& item : items) rows.push_back(write_list(form.write(item, style)));
              return rows;
            };
            describe_text_rows(table, name,
                               {.text = text, .need = given.need, .example = given.example, .source = source},
                               {append, [&items] { items.clear(); }, write});
          }};
}

/// A name with numbers: of a place its coordinates, m (two in the flat part, three in space; twice as many
/// are the two ends of a line), of a gate or a region what a key says about it.
struct NamedNumbers {
  std::string name;
  std::vector<double> numbers;
};
using NamedPlace = NamedNumbers;

/// Rows [name, x, y], [name, x, y, z], or with two ends where `lines` allows them.
enum class PlaceLines { no, allowed };
[[nodiscard]] RowForm<NamedPlace> place_rows(PlaceLines lines = PlaceLines::no);

/// Says how many numbers follow a name.
struct NumberCount {
  const char* fault;      ///< what a row with too few or too many is
  std::size_t least = 1;  ///< without the name
  std::size_t most = std::numeric_limits<std::size_t>::max();
};
/// Rows [name, number, …], one for each `owner` ("gate"); only unit and range of the column count.
[[nodiscard]] RowForm<NamedNumbers> number_rows(const char* owner, const Column& column, NumberCount count);

}  // namespace fiberfate
