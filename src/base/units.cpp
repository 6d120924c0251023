// Reads quantities with units through UDUNITS-2.
#include "base/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "base/memory.hpp"
#include "base/trimmed.hpp"

namespace fiberfate {
namespace {

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;
/// Powers of the base units, "m" to 1 and "s" to -1. Angles have a dimension here.
using Dimension = std::map<std::string, int>;

// UDUNITS keeps its last status in a global, so calls from several threads take turns.
std::mutex& udunits_turn() {
  static std::mutex turn;
  return turn;
}

/// What the library takes for its database and for a unit; it ends the program where its own allocations
/// fail.
constexpr std::size_t room_of_database = 4 << 20, room_of_unit = 1 << 20;

ut_system* unit_system() {
  static ut_system* system = [] {
    require_room(room_of_database);
    ut_set_error_message_handler(ut_ignore);
    return ut_read_xml(nullptr);
  }();
  if (system == nullptr)
    throw std::invalid_argument("the unit database of UDUNITS-2 is missing; install libudunits2-0");
  return system;
}

/// Writes typographic signs as the plain ones that they stand for: "−5 µm s⁻¹" with any kind of space.
std::string plain_signs(std::string_view text) {
  struct Sign {
    std::string_view written, plain;
  };
  static constexpr auto signs = std::to_array<Sign>({{"\u00A0", " "},
                                                     {"\u2007", " "},
                                                     {"\u2009", " "},
                                                     {"\u202F", " "},
                                                     {"\u2212", "-"},
                                                     {"\u207B\u00B9", "^-1"},
                                                     {"\u207B\u00B2", "^-2"},
                                                     {"\u207B\u00B3", "^-3"},
                                                     {"\u207B\u2074", "^-4"},
                                                     {"\u00B9", "^1"},
                                                     {"\u00B2", "^2"},
                                                     {"\u00B3", "^3"},
                                                     {"\u2074", "^4"},
                                                     {"\u00B7", "."},
                                                     {"\u22C5", "."},
                                                     {"\u00B5", "u"},
                                                     {"\u03BC", "u"}});
  std::string plain;
  while (!text.empty()) {
    const auto sign = std::find_if(signs.begin(), signs.end(),
                                   [text](const Sign& one) { return text.starts_with(one.written); });
    plain += sign == signs.end() ? text.substr(0, 1) : sign->plain;
    text.remove_prefix(sign == signs.end() ? 1 : sign->written.size());
  }
  return plain;
}

ut_status visit_basic(const ut_unit* unit, void* dimension) {
  const char* symbol = ut_get_symbol(unit, UT_ASCII);
  ++(*static_cast<Dimension*>(dimension))[symbol == nullptr ? ut_get_name(unit, UT_ASCII) : symbol];
  return UT_SUCCESS;
}

ut_status visit_product(const ut_unit*, int count, const ut_unit* const* units, const int* powers,
                        void* dimension) {
  for (int i = 0; i < count; ++i) {
    Dimension one;
    visit_basic(units[i], &one);
    for (const auto& [symbol, power] : one)
      (*static_cast<Dimension*>(dimension))[symbol] += power * powers[i];
  }
  return UT_SUCCESS;
}

ut_status visit_scaled(const ut_unit*, double, const ut_unit* underlying, double, void* dimension);

/// Dates and logarithms are no quantities here.
ut_status refuse_timestamp(const ut_unit*, const ut_unit*, double, void*) {
  return UT_VISIT_ERROR;
}
ut_status refuse_logarithm(const ut_unit*, double, const ut_unit*, void*) {
  return UT_VISIT_ERROR;
}

constexpr ut_visitor dimension_visitor = {visit_basic, visit_product, visit_scaled, refuse_timestamp,
                                          refuse_logarithm};

ut_status visit_scaled(const ut_unit*, double, const ut_unit* underlying, double, void* dimension) {
  return ut_accept_visitor(underlying, &dimension_visitor, dimension);
}

std::optional<Dimension> dimension_of(const Unit& unit) {
  Dimension dimension;
  if (ut_accept_visitor(unit.get(), &dimension_visitor, &dimension) != UT_SUCCESS) return std::nullopt;
  std::erase_if(dimension, [](const auto& power) { return power.second == 0; });
  return dimension;
}

Dimension without_angle(Dimension dimension) {
  dimension.erase("rad");
  return dimension;
}

bool are_reciprocal(const Dimension& a, const Dimension& b) {
  return !a.empty() && a.size() == b.size() && std::all_of(a.begin(), a.end(), [&b](const auto& power) {
    const auto found = b.find(power.first);
    return found != b.end() && found->second == -power.second;
  });
}

/// States what a letter means to UDUNITS where people mean a temperature by it.
std::string temperature_remark(const std::string& unit, const std::string& si_unit) {
  const auto has_symbol = [](const std::string& text, char symbol) {
    const auto is_letter = [&text](std::size_t i) {
      return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
    };
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == symbol && !(i > 0 && is_letter(i - 1)) && !is_letter(i + 1)) return true;
    return false;
  };
  if (!has_symbol(si_unit, 'K')) return "";
  if (has_symbol(unit, 'C'))
    return "; 'C' is coulomb: write 'degC' for degrees Celsius, 'K' for their differences";
  if (has_symbol(unit, 'F')) return "; 'F' is farad: write 'degF' for degrees Fahrenheit";
  return "";
}

/// Finds the common unit that differs only in capitals: "mpa" means MPa.
std::string meant_unit(const std::string& unit) {
  static constexpr std::array common = {"um", "mm",  "cm",  "m",   "ms",   "s",    "min",    "h",
                                        "Pa", "kPa", "MPa", "GPa", "K",    "degC", "kg",     "g",
                                        "N",  "W",   "J",   "1/s", "Pa s", "bar",  "kg/m^3", "g/cm^3"};
  const auto lower = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
  };
  const auto* found =
      std::find_if(common.begin(), common.end(), [&](const char* one) { return lower(one) == lower(unit); });
  return found == common.end() || unit == *found ? "" : fmt::format("; did you mean '{}'?", *found);
}

Unit parse_unit(const std::string& text) {
  require_room(room_of_unit);
  Unit unit(ut_parse(unit_system(), text.c_str(), UT_UTF8), ut_free);
  if (!unit) throw std::invalid_argument(fmt::format("'{}' is not a unit{}", text, meant_unit(text)));
  return unit;
}

/// Raises what is wrong with a unit of another dimension.
[[noreturn]] void refuse_dimension(const std::string& unit, const std::string& si_unit,
                                   const std::optional<Dimension>& from, const Dimension& to) {
  if (from && are_reciprocal(*from, to))
    throw std::invalid_argument(
        fmt::format("'{}' is the reciprocal of '{}', and is not converted into it", unit, si_unit));
  if (from && without_angle(*from) == without_angle(to))
    throw std::invalid_argument(fmt::format("'{}' counts turns or angles, and '{}' does not", unit, si_unit));
  throw std::invalid_argument(fmt::format("'{}' does not have the dimension of '{}'{}{}", unit, si_unit,
                                          temperature_remark(unit, si_unit), meant_unit(unit)));
}

/// Makes the converter between units of one dimension. UDUNITS itself also converts between a unit and its
/// reciprocal, and takes the radian for 1: a period would become a rate.
Converter converter_between(const std::string& unit, const std::string& si_unit) {
  const Unit from = parse_unit(unit);
  const Unit to = parse_unit(si_unit);
  const std::optional<Dimension> given = dimension_of(from);
  const Dimension wanted = dimension_of(to).value();
  if (given != wanted) refuse_dimension(unit, si_unit, given, wanted);
  Converter converter(ut_get_converter(from.get(), to.get()), cv_free);
  if (!converter) refuse_dimension(unit, si_unit, given, wanted);
  // "mm @ 5" counts from 5 mm; only temperatures are counted from elsewhere here.
  if (si_unit != "K" && cv_convert_double(converter.get(), 0.0) != 0)
    throw std::invalid_argument(fmt::format("'{}' is not a unit: it does not begin at 0", unit));
  return converter;
}

/// Takes off the rounding of a conversion: the nearest number of 15 digits where it is at most 4 ulp away, so
/// that "19 um" and 19e-6 are the same bits.
double without_conversion_error(double value) {
  const std::string digits = fmt::format("{:.14e}", value);
  double decimal = value;
  std::from_chars(digits.data(), digits.data() + digits.size(), decimal);
  const double ulp = std::nextafter(std::abs(value), INFINITY) - std::abs(value);
  return std::abs(decimal - value) <= 4 * ulp ? decimal : value;
}

bool is_digit(char letter) {
  return letter >= '0' && letter <= '9';
}

bool is_letter(char letter) {
  return std::isalpha(static_cast<unsigned char>(letter)) != 0 || (letter & 0x80) != 0;
}

/// Whether a digit of a unit belongs to an exponent: "m2", "s-1", "m^-2", "(m K)^2".
bool is_exponent(std::string_view unit, std::size_t digit) {
  std::string_view before = unit.substr(0, digit);
  if (before.ends_with('-') || before.ends_with('+')) before.remove_suffix(1);
  return !before.empty() && (is_letter(before.back()) || before.ends_with('^') || before.ends_with("**"));
}

/// Raises where a number goes on with another number: "1,5 mm", "1 000 um", "2 - 3 mm". UDUNITS takes the
/// second for a factor. "1/s" begins with one that people do write.
void require_no_second_number(std::string_view text, std::string_view unit) {
  if (unit.size() > 1 && unit[0] == ',' && is_digit(unit[1]))
    throw std::invalid_argument(fmt::format("'{}' has a decimal comma; write a decimal point", text));
  const bool reciprocal = unit.starts_with('1') && trimmed(unit.substr(1)).starts_with('/');
  for (std::size_t i = reciprocal ? 1 : 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i]) || (i > 0 && is_digit(unit[i - 1])) || is_exponent(unit, i)) continue;
    throw std::invalid_argument(
        fmt::format("'{}' holds two numbers; write one, without spaces inside, and its unit", text));
  }
}

}  // namespace

double unit_factor(const std::string& unit, const std::string& si_unit) {
  const std::string plain = plain_signs(unit);
  require_no_second_number(unit, trimmed(plain));
  const std::scoped_lock lock(udunits_turn());
  const Converter converter = converter_between(plain, si_unit);
  // Units with an offset (degC) are converted with quantity_in_si; the factor is the slope.
  return cv_convert_double(converter.get(), 1.0) - cv_convert_double(converter.get(), 0.0);
}

double quantity_in_si(std::string_view quantity, const std::string& si_unit) {
  const std::string plain = plain_signs(quantity);
  const std::string_view text = trimmed(plain);
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double number = 0;
  const auto [rest, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (status != std::errc() || !std::isfinite(number))
    throw std::invalid_argument(fmt::format("'{}' does not begin with a finite number", trimmed(quantity)));
  const std::string_view unit =
      trimmed(std::string_view(rest, static_cast<std::size_t>(digits.data() + digits.size() - rest)));
  if (unit.empty()) return number;
  require_no_second_number(text, unit);

  const std::scoped_lock lock(udunits_turn());
  const double converted = cv_convert_double(converter_between(std::string(unit), si_unit).get(), number);
  return std::isfinite(converted) ? without_conversion_error(converted) : converted;
}

}  // namespace fiberfate
