// Reads numbers with decimal points or commas.
#include "io/decimal_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/text_faults.hpp"

namespace fiberfate {
namespace {

bool is_digits(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char letter) { return letter >= '0' && letter <= '9'; });
}

/// Whether a comma can stand between thousands: "1,204", but not "0,512" or "1,5".
bool may_part_thousands(std::string_view text, std::size_t comma) {
  if (text.starts_with('-') || text.starts_with('+')) {
    text.remove_prefix(1);
    --comma;
  }
  const std::string_view before = text.substr(0, comma), after = text.substr(comma + 1);
  return is_digits(before) && before.size() <= 3 && before.front() != '0' && is_digits(after) &&
         after.size() == 3;
}

}  // namespace

std::optional<double> plain_number(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const auto [rest, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = status == std::errc() && rest == text.data() + text.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<double> DecimalColumn::read(std::string_view text, std::string& fault) {
  const auto comma = text.find(',');
  if (comma == std::string_view::npos) {
    const std::optional<double> number = plain_number(text);
    if (!number)
      fault =
          text.empty() ? "a number is missing" : fmt::format("'{}' is not a finite number", shortened(text));
    const bool point = text.find('.') != std::string_view::npos;
    points_ |= point;
    if (number && point && commas_)
      fault = fmt::format("'{}' has a point where others have a decimal comma", text);
    return fault.empty() ? number : std::nullopt;
  }
  std::string pointed(text);
  pointed[comma] = '.';
  const std::optional<double> number = plain_number(pointed);
  if (!number)
    fault = fmt::format("'{}' is not a finite number", shortened(text));
  else if (separator_ == ',' || separator_ == '\0')
    fault = fmt::format("'{}' has a decimal comma in a table of commas", text);
  else if (points_)
    fault = fmt::format("'{}' has a decimal comma where others have a point", text);
  commas_ = true;
  sure_commas_ |= !may_part_thousands(text, comma);
  return fault.empty() ? number : std::nullopt;
}

}  // namespace fiberfate
