// Reads TOML through toml11 and flattens it; the only source that includes that (slow) header.
#include "io/toml_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <toml.hpp>

#include "base/trimmed.hpp"
#include "io/input_file.hpp"
#include "io/text_faults.hpp"
#include "io/text_places.hpp"
#include "io/toml_scan.hpp"
#include "io/toml_syntax.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t longest_citation = 60;
constexpr std::uint64_t largest_case = std::uint64_t{1} << 26;  // bytes; a million rows of numbers

/// Builds the flat lists from toml11's tree.
class Flattener {
 public:
  Flattener(const std::string& name, const std::string& text, const BrokenText& broken)
      : name_(name), text_(text), broken_(broken), places_(text) {}

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
        entries.push_back({key, key_place(value), std::move(converted)});
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

  [[nodiscard]] InputPlace place_at(std::size_t offset) const {
    const TextPlace place = places_.at(offset);
    return {name_, place.line, place.column};
  }

  /// Where a value stands in the text.
  struct Span {
    std::size_t begin = 0, size = 0;
  };

  [[nodiscard]] Span span_of(const toml::value& value) const {
    const auto* region = dynamic_cast<const toml::detail::region*>(toml::detail::get_region(value));
    if (region == nullptr) return {};
    const std::size_t begin = region->first() - region->begin();
    const std::size_t first = broken_.original(begin);
    return {first, broken_.original(begin + region->size()) - first};
  }

  [[nodiscard]] InputPlace place_of(const toml::value& value) const { return place_at(span_of(value).begin); }

  /// Finds the key to the left of a value; where the line does not show it, the value's own place.
  [[nodiscard]] InputPlace key_place(const toml::value& value) const {
    const std::size_t begin = span_of(value).begin;
    const InputPlace place = place_at(begin);
    const std::size_t column = place.column - 1;
    const std::string_view before = text_.substr(begin - column, column);
    const auto equals = before.find_last_of('=');
    if (equals == std::string_view::npos) return place;
    const auto last = before.find_last_not_of(" \t", equals == 0 ? 0 : equals - 1);
    if (last == std::string_view::npos) return place;
    const auto gap = before.find_last_of(" \t,{", last);
    return {place.file, place.line, static_cast<int>(gap == std::string_view::npos ? 0 : gap + 1) + 1};
  }

  /// Cites a value as it stands in the file, folding line breaks and spaces, shortened to a line.
  [[nodiscard]] std::string citation(const toml::value& value) const {
    const auto [begin, size] = span_of(value);
    std::string_view rest = text_.substr(begin, size);
    std::string cited;
    while (!rest.empty() && cited.size() <= longest_citation) {
      std::string_view line = rest.substr(0, std::min(rest.find('\n'), rest.size()));
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
      if (line.ends_with('\r')) line.remove_suffix(1);
      const auto first = line.find_first_not_of(" \t");
      if (first == std::string_view::npos) continue;
      if (!cited.empty()) cited += ' ';
      cited += line.substr(first, longest_citation + 1);
    }
    return shortened(cited, longest_citation);
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
  std::string_view text_;
  const BrokenText& broken_;
  TextPlaces places_;
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
  if (const std::string fault = reading_fault(path, largest_case); !fault.empty())
    refuse(path, fault, unreadable_remedy(path));
  return parse(read_input_file(path, largest_case), path);
}

TomlDocument TomlDocument::parse(const std::string& text, const std::string& name) {
  std::string whole(without_byte_order_mark(text));
  // A last line without its end confuses toml11's places.
  if (!whole.ends_with('\n')) whole += '\n';
  if (const auto problem = text_fault(whole, name)) throw InputError({*problem});
  TomlScan scan = scan_toml(whole, name);
  if (scan.fault) throw InputError({*scan.fault});
  const BrokenText broken(whole, std::move(scan.breaks));
  Flattener flattener(name, whole, broken);
  try {
    std::istringstream stream(broken.text());
    flattener.flatten(toml::parse(stream, name), "");
  } catch (const toml::exception& error) {
    throw InputError({syntax_problem(error.what(), name, {whole, broken})});
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
  const std::string key(trimmed(std::string_view(assignment).substr(0, equals)));
  if (equals == std::string::npos || key.empty())
    refuse("command line", fmt::format("--set {}: this is not an assignment", assignment),
           "write --set key=value, for example --set fibers.length=\"2 mm\"");
  const std::string text(trimmed(std::string_view(assignment).substr(equals + 1)));

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
