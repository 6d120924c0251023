// Refuses numbers that a formula cannot take, and names the parameter that holds them.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace fiberfate {

/// Which numbers a parameter may take; all ranges hold finite numbers only.
struct NumberRange {
  double lower = -std::numeric_limits<double>::max();
  double upper = std::numeric_limits<double>::max();
  bool above_lower = false;  ///< the lower end itself is out

  /// Whether a number lies in the range; NaN and infinities do not.
  [[nodiscard]] bool holds(double value) const {
    return (value >= lower) & (value <= upper) & !(above_lower & (value == lower));
  }
};

inline constexpr NumberRange any_finite = {};
inline constexpr NumberRange not_negative = {.lower = 0};
inline constexpr NumberRange positive = {.lower = 0, .above_lower = true};

/// Raises InputError for a number outside its range; the problem's key is the path of the parameter, "C_I".
[[noreturn]] void refuse_number(std::string_view path, double value, const NumberRange& range);
/// Raises InputError for a number outside its range at a place of an array, "rate[17]".
[[noreturn]] void refuse_number(std::string_view path, std::size_t place, double value,
                                const NumberRange& range);

/// Raises InputError unless the range holds the number.
inline void require_number(std::string_view path, double value, const NumberRange& range) {
  if (!range.holds(value)) refuse_number(path, value, range);
}

/// Raises InputError, which names the place, unless the range holds every number.
template <class Numbers>
void require_numbers(std::string_view path, const Numbers& values, const NumberRange& range) {
  bool sound = true;  // looked at once at the end: arrays of millions of numbers are the rule
  for (const double value : values) sound &= range.holds(value);
  if (sound) return;
  std::size_t place = 0;
  for (const double value : values) {
    if (!range.holds(value)) refuse_number(path, place, value, range);
    ++place;
  }
}

/// Raises InputError unless two arrays that belong together have one size.
void require_same_size(std::string_view path, std::size_t size, std::size_t expected);

}  // namespace fiberfate
