// Reads and writes the single values of case files: quantities with units, their ranges and their lists.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "io/toml_document.hpp"

namespace fiberfate {

/// What is wrong with a value and what to do about it.
struct Complaint {
  std::string what;
  std::string remedy;
  const TomlValue* at = nullptr;  ///< the item of a list that is at fault; null: the whole value
};

/// How numbers are written: with a unit that people use, or bare in SI so that reading gives the same
/// bits.
enum class NumberStyle { friendly, si };

/// Bounds a quantity, in SI.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  enum class Ends { closed, open_low, open_high, open } ends = Ends::closed;

  static Range any() { return {}; }
  static Range positive(double high = std::numeric_limits<double>::infinity()) {
    return {0, high, Ends::open_low};
  }
  static Range not_negative() { return at_least(0); }
  static Range at_least(double low) { return {low, std::numeric_limits<double>::infinity(), Ends::closed}; }
  static Range between(double low, double high) { return {low, high, Ends::closed}; }
  static Range inside(double low, double high) { return {low, high, Ends::open}; }

  [[nodiscard]] bool contains(double value) const;
};

/// The units of a quantity: SI in memory, friendly in templates and messages.
struct Units {
  std::string si = "1";
  std::string friendly = {};  ///< empty: the same as `si`
};

/// Describes one column of a key that holds rows.
struct Column {
  std::string name;  ///< "time"
  Units units;
  Range range;
};

/// Reads a value or tells what is wrong with it.
template <class T>
using Reading = std::variant<T, Complaint>;

/// Reads a quantity ("19 um" or a bare SI number) of the given unit and range; it must be finite.
[[nodiscard]] Reading<double> read_quantity(const TomlValue& value, const Units& units, const Range& range);
/// Writes a quantity as TOML: `"19 um"` or `1.9e-05`.
[[nodiscard]] std::string write_quantity(double value, const Units& units, NumberStyle style);
/// Writes a number such that reading it gives the same bits.
[[nodiscard]] std::string write_number(double value);
/// Writes a text in quotes.
[[nodiscard]] std::string write_text(const std::string& text);
/// Writes a list of values that are TOML already.
[[nodiscard]] std::string write_list(const std::vector<std::string>& items);
/// Describes a range for people: "more than 0 um", "0 to 1", "any number".
[[nodiscard]] std::string describe_range(const Range& range, const Units& units);

}  // namespace fiberfate
