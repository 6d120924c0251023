// Reads and writes quantities, texts and paths of case files.
#include "keys/key_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/units.hpp"

namespace fiberfate {
namespace {

constexpr std::array<const char*, 7> prefixes = {"n", "u", "m", "", "k", "M", "G"};
constexpr int least_prefix = 3;  ///< thousands below one of the first prefix

bool has_prefixes(const std::string& unit) {
  return unit == "m" || unit == "s" || unit == "Pa" || unit == "m/s";
}

bool is_pure_number(const Units& units) {
  return units.si == "1" && units.friendly.empty();
}

/// Chooses the unit to show a value in: the friendly one where there is one, else the SI unit with the prefix
/// that leaves one to three digits before the point.
std::string shown_unit(double value, const Units& units) {
  if (!units.friendly.empty()) return units.friendly;
  if (!has_prefixes(units.si) || value == 0) return units.si;
  const auto thousands = static_cast<int>(std::floor(std::log10(std::abs(value)) / 3 + 1e-9));
  const int limited =
      std::clamp(thousands, -least_prefix, static_cast<int>(prefixes.size()) - 1 - least_prefix);
  return prefixes[limited + least_prefix] + units.si;
}

/// Finds the shortest number that, read in the unit, gives `value` back to the last digit.
double shown_number(double value, const std::string& unit, const std::string& si) {
  const double number = value / unit_factor(unit, si);
  for (int digits = 0; digits <= 16; ++digits) {
    const std::string text = fmt::format("{:.{}e}", number, digits);
    if (quantity_in_si(text + ' ' + unit, si) == value) return quantity_in_si(text, "1");
  }
  return number;
}

std::string with_unit(double value, const Units& units) {
  if (is_pure_number(units)) return fmt::format("{}", value);
  const std::string unit = shown_unit(value, units);
  return fmt::format("{} {}", shown_number(value, unit, units.si), unit);
}

/// Writes a bound of a range: in the best unit, and zero without any.
std::string bound(double value, const Units& units) {
  if (value == 0) return "0";
  if (is_pure_number(units) || units.friendly == "%") return with_unit(value, units);
  if (std::abs(value) < 1e5 || units.si == "Pa") return with_unit(value, {units.si, ""});
  return fmt::format("{:g} {}", value, units.si);
}

std::string how_to_write(const Units& units) {
  if (is_pure_number(units)) return "give a number";
  if (units.si == "1") return fmt::format("give a number, or a text such as \"10 {}\"", units.friendly);
  return fmt::format("give a number with a unit in quotes, such as \"1 {}\"",
                     units.friendly.empty() ? units.si : units.friendly);
}

/// A bare number that is out of range has often been meant in another unit.
Complaint out_of_range(double number, const TomlValue& value, const Units& units, const Range& range) {
  const std::string remedy = "give " + describe_range(range, units);
  const bool bare = !std::holds_alternative<std::string>(value.data);
  if (bare && units.si != "1")
    return {"out of range", remedy + fmt::format(" (a number without unit is in {})", units.si)};
  const bool is_percentage =
      units.si == "1" && range.high > 0.5 && range.high <= 1 && number > 1 && number <= 100;
  if (bare && is_percentage)
    return {fmt::format("out of range; it means {:g} %", 100 * number),
            fmt::format("{}, or \"{:g} %\"", remedy, number)};
  return {"out of range", remedy};
}

}  // namespace

bool Range::contains(double value) const {
  const bool above = ends == Ends::open_low || ends == Ends::open ? value > low : value >= low;
  const bool below = ends == Ends::open_high || ends == Ends::open ? value < high : value <= high;
  return above && below;
}

std::string describe_range(const Range& range, const Units& units) {
  const bool has_low = std::isfinite(range.low), has_high = std::isfinite(range.high);
  const bool open_low = range.ends == Range::Ends::open_low || range.ends == Range::Ends::open;
  const bool open_high = range.ends == Range::Ends::open_high || range.ends == Range::Ends::open;
  const auto show = [&units](double value) { return bound(value, units); };
  if (!has_low && !has_high) return "any number";
  if (has_low && has_high && !open_low && !open_high)
    return fmt::format("{} to {}", show(range.low), show(range.high));
  std::string text;
  if (has_low) text = fmt::format("{} {}", open_low ? "more than" : "at least", show(range.low));
  if (has_low && has_high) text += " and ";
  if (has_high) text += fmt::format("{} {}", open_high ? "less than" : "at most", show(range.high));
  return text;
}

Reading<double> read_quantity(const TomlValue& value, const Units& units, const Range& range) {
  double number = 0;
  if (const auto* real = std::get_if<double>(&value.data)) {
    number = *real;
  } else if (const auto* whole = std::get_if<std::int64_t>(&value.data)) {
    number = static_cast<double>(*whole);
  } else if (const auto* text = std::get_if<std::string>(&value.data)) {
    try {
      number = quantity_in_si(*text, units.si);
    } catch (const std::invalid_argument& error) {
      return Complaint{error.what(), how_to_write(units)};
    }
  } else {
    return Complaint{fmt::format("{} is not a quantity", value.kind()), how_to_write(units)};
  }
  if (!std::isfinite(number)) return Complaint{"not a finite number", how_to_write(units)};
  if (!range.contains(number)) return out_of_range(number, value, units, range);
  return number;
}

std::string write_number(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string write_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      quoted += '\\';
      quoted += letter;
    } else if (code < 0x20 || code == 0x7F) {
      quoted += fmt::format("\\u{:04X}", code);
    } else {
      quoted += letter;
    }
  }
  return quoted + '"';
}

std::string write_quantity(double value, const Units& units, NumberStyle style) {
  if (style == NumberStyle::si || is_pure_number(units)) return write_number(value);
  return write_text(with_unit(value, units));
}

std::string write_list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

}  // namespace fiberfate
