// Reads and writes keys that hold rows of names and quantities, such as ["G1", "10 mm", "20 mm"].
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "keys/key_table.hpp"

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

/// A place of a part: two numbers are coordinates in the flat part, three are in space; twice as many
/// are the two ends of a line.
struct NamedPlace {
  std::string name;
  std::vector<double> numbers;  ///< m
};

/// Adds a key that holds rows [name, x, y], [name, x, y, z], or with two ends where `lines` allows them.
enum class PlaceLines { no, allowed };
void describe_places(KeyTable& table, const std::string& key, std::vector<NamedPlace>& places,
                     PlaceLines lines, KeyNotes notes);

}  // namespace fiberfate
