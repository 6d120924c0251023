// Describes the keys of a case once; reading, templates, explanations and documentation all follow from it.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/vector.hpp"
#include "keys/key_value.hpp"

namespace fiberfate {

/// Whether a case may leave a key out.
enum class Need {
  optional,
  usual,     ///< only some cases leave it out, so a template gives the example
  required,  ///< every case gives it; the example helps
};

/// Everything about a key that is not its value.
struct KeyNotes {
  std::string text;           ///< what it means, one or two sentences
  std::string unit = "1";     ///< SI unit of the value in memory; "1" for a pure number
  std::string friendly = {};  ///< unit that templates write; empty: the same as `unit`
  Range range = {};           ///< admissible values, in SI
  Need need = Need::optional;
  std::string example = {};  ///< TOML text that a template shows where there is no default
  std::string source = {};   ///< where the default or the definition comes from
};

/// A name that a key may hold.
struct NamedText {
  std::string name;
  std::string meaning;
  std::string source = {};  ///< of a law: author, journal, year
};
using NamedTexts = std::vector<NamedText>;

/// One value of an enum in case files.
template <class Enum>
struct Choice {
  Enum value;
  const char* name;
  const char* text;
  const char* source = "";
};

/// Binds one key to a member of a case struct.
struct Key {
  std::string name;  ///< full, "fibers.length"
  KeyNotes notes;
  std::string kind;    ///< "quantity", "whole number", "choice", …, for explanations
  NamedTexts choices;  ///< of a key that holds one of several names
  /// Reads a value into the member; tells all that is wrong with it.
  std::function<std::vector<Complaint>(const TomlValue&)> read;
  /// Writes the member as TOML; empty when it is not given.
  std::function<std::string(NumberStyle)> write;

  [[nodiscard]] std::string section() const;  ///< "fibers"; empty for a key outside any table
  [[nodiscard]] std::string leaf() const;     ///< "length"
};

/// Heads a group of keys: one TOML table.
struct Section {
  std::string name;  ///< "fibers"; "fibers.more_kinds.2" of a table that is repeated
  std::string text;
};

/// Writes a name without the numbers of repeated tables: "fibers.more_kinds.2.length" is
/// "fibers.more_kinds.length".
[[nodiscard]] std::string without_numbers(const std::string& name);
/// Writes the heading of a table: "[fibers]"; "[[fibers.more_kinds]]" of one that is repeated.
[[nodiscard]] std::string table_heading(const std::string& section);

/// Collects the keys of one case. A study's describe() adds every key with the member it lives in; the
/// members' values at that moment are the defaults. The case must outlive the table.
class KeyTable {
 public:
  /// How many of the tables that a case may repeat are described: as many as the case has, or one each.
  enum class Repeats { of_case, one_to_show };
  /// Makes a table of keys that are written or shown.
  explicit KeyTable(Repeats repeats = Repeats::of_case) : repeats_(repeats) {}
  /// Makes a table of keys that are read from a document; takes the folder against which relative paths are
  /// read.
  KeyTable(std::string folder, const TomlDocument& document)
      : folder_(std::move(folder)), document_(&document) {}

  void section(std::string name, std::string text);
  /// A table that a case may give several times, [[name]]: makes an item for each and lets `describe` add the
  /// keys of the tables "name.1", "name.2", ….
  template <class Item, class Describe>
  void repeated(const std::string& name, std::vector<Item>& items, const Describe& describe) {
    repeated_.push_back(name);
    items.resize(count_repeated(name, items.size()));
    for (std::size_t i = 0; i < items.size(); ++i) describe(repeated_name(name, i), items[i]);
  }
  /// The name of one of several tables, counted from 0.
  [[nodiscard]] static std::string repeated_name(const std::string& name, std::size_t place) {
    return name + '.' + std::to_string(place + 1);
  }
  /// Whether this is the name of tables that a case may repeat.
  [[nodiscard]] bool is_repeated(const std::string& name) const;
  /// The tables that a case may give, those that may be repeated without a number.
  [[nodiscard]] std::vector<std::string> table_names() const;

  void quantity(const std::string& key, double& member, KeyNotes notes);
  /// A quantity without default.
  void quantity(const std::string& key, std::optional<double>& member, KeyNotes notes);
  /// A list of quantities of one unit.
  void quantities(const std::string& key, std::vector<double>& member, KeyNotes notes);
  /// Three quantities; with `Cubic::allowed` one number stands for three equal ones.
  enum class Cubic { no, allowed };
  void vector(const std::string& key, std::optional<Vec3>& member, Cubic cubic, KeyNotes notes);
  /// A whole number.
  template <class Integer>
  void count(const std::string& key, Integer& member, KeyNotes notes) {
    add_count(
        key, std::move(notes), [&member] { return std::optional<std::int64_t>(member); },
        [&member](std::int64_t value) { member = static_cast<Integer>(value); });
  }
  /// A whole number without default.
  void count(const std::string& key, std::optional<std::int64_t>& member, KeyNotes notes) {
    add_count(
        key, std::move(notes), [&member] { return member; },
        [&member](std::int64_t value) { member = value; });
  }
  /// One of several names.
  template <class Enum>
  void choice(const std::string& key, Enum& member, const std::vector<Choice<Enum>>& all, KeyNotes notes) {
    NamedTexts names;
    for (const Choice<Enum>& one : all) names.push_back({one.name, one.text, one.source});
    add_choice(
        key, std::move(notes), std::move(names),
        [&member, all] {
          std::size_t i = 0;
          while (i + 1 < all.size() && all[i].value != member) ++i;
          return i;
        },
        [&member, all](std::size_t i) { member = all[i].value; });
  }
  template <class Enum>
  void choice(const std::string& key, Enum& member, std::initializer_list<Choice<Enum>> choices,
              KeyNotes notes) {
    choice(key, member, std::vector<Choice<Enum>>(choices), std::move(notes));
  }
  /// The path of a file, relative to the case file; kept absolute.
  void file(const std::string& key, std::string& member, KeyNotes notes);
  /// A material of the program's or the path of a file like it, whose values stand for the keys that a case
  /// leaves out (add_preset). A resolved case, which has them all, does not name it any more.
  void preset(const std::string& key, std::string& member, KeyNotes notes);
  /// Rows of quantities, one unit a column, or the path of a text file that holds them in SI units.
  void rows(const std::string& key, std::vector<std::vector<double>>& member, std::vector<Column> columns,
            KeyNotes notes);
  /// A second-order orientation tensor: "isotropic", "planar", "aligned", three principal values, or 3×3
  /// components.
  void orientation(const std::string& key, Mat3& member, KeyNotes notes);
  /// Any other kind of value.
  void add(Key key);

  /// The folder against which relative paths are read.
  [[nodiscard]] const std::string& folder() const { return folder_; }
  [[nodiscard]] const std::vector<Key>& keys() const { return keys_; }
  [[nodiscard]] const std::vector<Section>& sections() const { return sections_; }
  [[nodiscard]] const Key* find(const std::string& key) const;

 private:
  [[nodiscard]] std::size_t count_repeated(const std::string& name, std::size_t present) const;
  void add_count(const std::string& key, KeyNotes notes, std::function<std::optional<std::int64_t>()> value,
                 std::function<void(std::int64_t)> set);
  void add_choice(const std::string& key, KeyNotes notes, NamedTexts names,
                  std::function<std::size_t()> index, std::function<void(std::size_t)> set);
  std::string folder_ = ".";
  const TomlDocument* document_ = nullptr;
  Repeats repeats_ = Repeats::of_case;
  std::vector<std::string> repeated_;
  std::unordered_map<std::string, std::size_t> places_;  ///< of keys, by name
  std::vector<Section> sections_;
  std::vector<Key> keys_;
};

}  // namespace fiberfate
