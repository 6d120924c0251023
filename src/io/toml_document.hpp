// Reads a TOML file into a flat list of keys and values that remember where they were written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {

/// Where something stands in an input.
struct InputPlace {
  std::string file;  ///< path as the user gave it, or "command line"
  int line = 0;      ///< from 1; 0 on the command line
  int column = 0;    ///< from 1; 0 on the command line
};

/// One value of a TOML file: a boolean, whole number, number, text, or a list of values.
struct TomlValue {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<TomlValue>> data;
  std::string written;  ///< as it stands in the file, line breaks folded, shortened when long
  InputPlace place;

  /// The kind for messages: "a text", "a whole number", …; "a date" stands for all that has no use
  /// here.
  [[nodiscard]] const char* kind() const;
};

/// One key, full ("fibers.length"), with its value.
struct TomlEntry {
  std::string key;
  InputPlace place;  ///< of the key
  TomlValue value;
};

/// One table ("fibers"), written as [fibers] or implied by a dotted key; tables that are repeated,
/// [[fibers.kinds]], are "fibers.kinds.1", "fibers.kinds.2", ….
struct TomlTable {
  std::string name;
  InputPlace place;
};

/// A TOML file flattened to full keys, in the order in which they were written.
class TomlDocument {
 public:
  /// Reads a file; raises InputError when it cannot be read or is not TOML.
  static TomlDocument read(const std::string& path);
  /// Reads a text that messages call `name`; raises InputError when it is not TOML.
  static TomlDocument parse(const std::string& text, const std::string& name);

  /// Sets a key from the command line, "fibers.length=2 mm"; a later one replaces an earlier one and the
  /// file's. The value is read as TOML where it is TOML, else as text, so that units need no second pair of
  /// quotes. Raises InputError when there is no '=' or no key.
  void override_with(const std::string& assignment);
  /// Sets a key to an entry of another file; messages go on to cite that file.
  void replace(TomlEntry entry);

  /// Adds entries of another document behind its own; they keep their places.
  void add(std::vector<TomlEntry> entries);
  /// Finds a key; null when it is not given.
  [[nodiscard]] const TomlEntry* find(std::string_view key) const;
  /// Whether there is a table of this name.
  [[nodiscard]] bool has_table(std::string_view name) const;
  [[nodiscard]] const std::vector<TomlEntry>& entries() const { return entries_; }
  [[nodiscard]] const std::vector<TomlTable>& tables() const { return tables_; }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::vector<TomlEntry> entries_;
  std::vector<TomlTable> tables_;
};

/// Starts the problem of an entry: place, key and value filled in.
[[nodiscard]] InputProblem problem_at(const TomlEntry& entry);

}  // namespace fiberfate
