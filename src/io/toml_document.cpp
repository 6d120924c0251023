// Reads TOML through toml11 and flattens it; the only source that includes that (slow) header.
#include "io/toml_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <toml.hpp>

#include "io/toml_syntax.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t longest_citation = 60;

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.ends_with('\r')) line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

/// Builds the flat lists from toml11's tree.
class Flattener {
 public:
  Flattener(std::string name, const std::string& text) : name_(std::move(name)), lines_(split_lines(text)) {}

  void flatten(const toml::value& table, const std::string& prefix) {
    for (const auto& [leaf, value] : table.as_table()) {
      const std::string key = prefix.empty() ? leaf : prefix + '.' + leaf;
      if (value.is_table()) {
        tables.push_back({key, place_of(value)});
        flatten(value, key);
      } else if (holds_tables(value)) {
        std::size_t count = 0;
        for (const toml::value& item : value.as_array()) {
          const std::string name = fmt::format("{}.{}", key, ++count);
          tables.push_back({name, place_of(item)});
          flatten(item, name);
        }
      } else {
        TomlValue converted = convert(value);
        entries.push_back({key, key_place(converted.place), std::move(converted)});
      }
    }
  }

  std::vector<TomlEntry> entries;
  std::vector<TomlTable> tables;

 private:
  [[nodiscard]] static bool holds_tables(const toml::value& value) {
    return value.is_array() && !value.as_array().empty() &&
           std::all_of(value.as_array().begin(), value.as_array().end(),
                       [](const toml::value& item) { return item.is_table(); });
  }

  [[nodiscard]] InputPlace place_of(const toml::value& value) const {
    const auto location = value.location();
    return {name_, static_cast<int>(location.line()), static_cast<int>(location.column())};
  }

  /// Finds the key to the left of a value; where the line does not show it, the value's own place.
  [[nodiscard]] InputPlace key_place(const InputPlace& value) const {
    const auto row = static_cast<std::size_t>(value.line) - 1;
    if (row >= lines_.size()) return value;
    const std::string before = lines_[row].substr(0, static_cast<std::size_t>(value.column) - 1);
    const auto equals = before.find_last_of('=');
    if (equals == std::string::npos) return value;
    const auto last = before.find_last_not_of(" \t", equals == 0 ? 0 : equals - 1);
    if (last == std::string::npos) return value;
    const auto gap = before.find_last_of(" \t,{", last);
    return {value.file, value.line, static_cast<int>(gap == std::string::npos ? 0 : gap + 1) + 1};
  }

  /// Cites a value as it stands in the file, folding line breaks and spaces, shortened to a line.
  [[nodiscard]] std::string citation(const toml::value& value) const {
    const auto location = value.location();
    std::size_t left = location.region();
    std::size_t from = location.column() - 1;
    std::string cited;
    for (std::size_t row = location.line() - 1; row < lines_.size() && left > 0; ++row, from = 0) {
      const std::string piece = from < lines_[row].size() ? lines_[row].substr(from, left) : "";
      const auto first = piece.find_first_not_of(" \t");
      if (first != std::string::npos) cited += (cited.empty() || from > 0 ? "" : " ") + piece.substr(first);
      left -= std::min(left, piece.size() + 1);
    }
    if (cited.size() > longest_citation) cited = cited.substr(0, longest_citation - 3) + "...";
    return cited;
  }

  [[nodiscard]] TomlValue convert(const toml::value& value) const {
    TomlValue result;
    result.place = place_of(value);
    result.written = citation(value);
    if (value.is_boolean()) result.data = value.as_boolean();
    if (value.is_string()) result.data = value.as_string().str;
    if (value.is_integer()) result.data = static_cast<std::int64_t>(value.as_integer());
    if (value.is_floating()) result.data = value.as_floating();
    if (value.is_integer() || value.is_floating()) unsaturate(result);
    if (value.is_array()) {
      std::vector<TomlValue> items;
      for (const toml::value& item : value.as_array()) items.push_back(convert(item));
      result.data = std::move(items);
    }
    return result;
  }

  /// toml11 turns a number that is too large into the largest one; make it the infinity that it is.
  static void unsaturate(TomlValue& value) {
    const auto* real = std::get_if<double>(&value.data);
    const auto* whole = std::get_if<std::int64_t>(&value.data);
    using Real = std::numeric_limits<double>;
    using Whole = std::numeric_limits<std::int64_t>;
    const bool large_real = real != nullptr && std::abs(*real) == Real::max();
    const bool large_whole = whole != nullptr && (*whole == Whole::max() || *whole == Whole::min());
    if (large_real) value.data = std::copysign(Real::infinity(), *real);
    if (large_whole) value.data = std::copysign(Real::infinity(), static_cast<double>(*whole));
  }

  std::string name_;
  std::vector<std::string> lines_;
};

std::string unreadable_remedy(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  const std::string nearest = nearest_word(fs::path(path).filename().string(), names);
  if (!nearest.empty())
    return fmt::format("did you mean '{}'?", (folder / nearest).lexically_normal().string());
  return "check the path, or make a case with 'fiberfate new shear_cell'";
}

[[noreturn]] void refuse(const std::string& file, std::string complaint, std::string remedy) {
  throw InputError({{file, 0, 0, "", "", std::move(complaint), std::move(remedy)}});
}

bool stands_earlier(const InputPlace& a, const InputPlace& b) {
  return a.line != b.line ? a.line < b.line : a.column < b.column;
}

}  // namespace

const char* TomlValue::kind() const {
  static constexpr const char* names[] = {"a date or table", "a boolean", "a whole number",
                                          "a number",        "a text",    "a list"};
  return names[data.index()];
}

TomlDocument TomlDocument::read(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    const auto inside = (std::filesystem::path(path) / "case.toml").lexically_normal();
    const bool found = std::filesystem::exists(inside, ignored);
    refuse(path, "is a folder, not a case file",
           found ? fmt::format("give '{}'", inside.string()) : "give the case file in it");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path, fmt::format("cannot be read ({})", std::strerror(errno)), unreadable_remedy(path));
  std::ostringstream text;
  text << file.rdbuf();
  return parse(text.str(), path);
}

TomlDocument TomlDocument::parse(const std::string& text, const std::string& name) {
  if (text.find('\0') != std::string::npos)
    refuse(name, "is not a text file", "give a case file in TOML, as 'fiberfate new shear_cell' writes it");
  // A last line without its end confuses toml11's places.
  const std::string whole = text.ends_with('\n') ? text : text + '\n';
  Flattener flattener(name, whole);
  try {
    std::istringstream stream(whole);
    flattener.flatten(toml::parse(stream, name), "");
  } catch (const toml::exception& error) {
    throw InputError({syntax_problem(error.what(), name, split_lines(whole))});
  }
  TomlDocument document;
  document.name_ = name;
  document.entries_ = std::move(flattener.entries);
  document.tables_ = std::move(flattener.tables);
  std::sort(document.entries_.begin(), document.entries_.end(),
            [](const TomlEntry& a, const TomlEntry& b) { return stands_earlier(a.place, b.place); });
  std::sort(document.tables_.begin(), document.tables_.end(), [](const TomlTable& a, const TomlTable& b) {
    return a.place.line != b.place.line ? a.place.line < b.place.line : a.name < b.name;
  });
  return document;
}

void TomlDocument::override_with(const std::string& assignment) {
  const InputPlace place{"command line", 0, 0};
  const auto equals = assignment.find('=');
  const auto trim = [](std::string text) {
    text.erase(0, text.find_first_not_of(" \t"));
    text.erase(text.find_last_not_of(" \t") + 1);
    return text;
  };
  const std::string key = trim(assignment.substr(0, equals));
  if (equals == std::string::npos || key.empty())
    refuse("command line", fmt::format("--set {}: this is not an assignment", assignment),
           "write --set key=value, for example --set fibers.length=\"2 mm\"");
  const std::string text = trim(assignment.substr(equals + 1));

  TomlValue value{text, '"' + text + '"', place};
  try {
    const TomlDocument parsed = parse("value = " + text, "command line");
    if (parsed.entries_.size() == 1 && parsed.tables_.empty()) value = parsed.entries_.front().value;
  } catch (const InputError&) {  // not TOML: the text itself is the value
  }
  value.place = place;
  replace({key, place, std::move(value)});
}

void TomlDocument::replace(TomlEntry entry) {
  std::erase_if(entries_, [&entry](const TomlEntry& old) { return old.key == entry.key; });
  entries_.push_back(std::move(entry));
}

void TomlDocument::add(std::vector<TomlEntry> entries) {
  for (TomlEntry& entry : entries) entries_.push_back(std::move(entry));
}

const TomlEntry* TomlDocument::find(std::string_view key) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [key](const TomlEntry& entry) { return entry.key == key; });
  return found == entries_.end() ? nullptr : &*found;
}

bool TomlDocument::has_table(std::string_view name) const {
  return std::any_of(tables_.begin(), tables_.end(),
                     [name](const TomlTable& table) { return table.name == name; });
}

InputProblem problem_at(const TomlEntry& entry) {
  const InputPlace& place = entry.value.place;
  return {place.file, place.line, place.column, entry.key, entry.value.written, "", ""};
}

}  // namespace fiberfate
