// Reads quantities with units through UDUNITS-2.
#include "base/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>

namespace fiberfate {
namespace {

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;

// UDUNITS keeps its last status in a global, so calls from several threads take turns.
std::mutex& udunits_turn() {
  static std::mutex turn;
  return turn;
}

ut_system* unit_system() {
  static ut_system* system = [] {
    ut_set_error_message_handler(ut_ignore);
    return ut_read_xml(nullptr);
  }();
  if (system == nullptr)
    throw std::invalid_argument("the unit database of UDUNITS-2 is missing; install libudunits2-0");
  return system;
}

Unit parse_unit(const std::string& text) {
  return Unit(ut_parse(unit_system(), text.c_str(), UT_UTF8), ut_free);
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
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

}  // namespace

double unit_factor(const std::string& unit, const std::string& si_unit) {
  const std::scoped_lock lock(udunits_turn());
  const Unit from = parse_unit(unit);
  if (!from) throw std::invalid_argument(fmt::format("'{}' is not a unit", unit));
  const Unit to = parse_unit(si_unit);
  if (!to) throw std::invalid_argument(fmt::format("'{}' is not a unit", si_unit));
  std::unique_ptr<cv_converter, decltype(&cv_free)> converter(ut_get_converter(from.get(), to.get()),
                                                              cv_free);
  if (!converter)
    throw std::invalid_argument(fmt::format("'{}' does not have the dimension of '{}'", unit, si_unit));
  // Units with an offset (degC) are converted with quantity_in_si; the factor is the slope.
  return cv_convert_double(converter.get(), 1.0) - cv_convert_double(converter.get(), 0.0);
}

double quantity_in_si(std::string_view quantity, const std::string& si_unit) {
  const std::string_view text = trimmed(quantity);
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double number = 0;
  const auto [rest, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (status != std::errc() || !std::isfinite(number))
    throw std::invalid_argument(fmt::format("'{}' does not begin with a finite number", text));
  const std::string_view unit =
      trimmed(std::string_view(rest, static_cast<std::size_t>(digits.data() + digits.size() - rest)));
  if (unit.empty()) return number;

  const std::scoped_lock lock(udunits_turn());
  const Unit from = parse_unit(std::string(unit));
  if (!from) throw std::invalid_argument(fmt::format("'{}' is not a unit", unit));
  const Unit to = parse_unit(si_unit);
  if (!to) throw std::invalid_argument(fmt::format("'{}' is not a unit", si_unit));
  std::unique_ptr<cv_converter, decltype(&cv_free)> converter(ut_get_converter(from.get(), to.get()),
                                                              cv_free);
  if (!converter)
    throw std::invalid_argument(fmt::format("'{}' does not have the dimension of '{}'", unit, si_unit));
  const double converted = cv_convert_double(converter.get(), number);
  return std::isfinite(converted) ? without_conversion_error(converted) : converted;
}

}  // namespace fiberfate
