// Whether numbers rise.
#pragma once

#include <algorithm>
#include <iterator>

namespace fiberfate {

/// Whether each number is greater than the one before; NaN is not.
template <class Numbers>
[[nodiscard]] bool are_rising(const Numbers& numbers) {
  const auto does_not_rise = [](double first, double second) { return !(first < second); };
  return std::adjacent_find(std::begin(numbers), std::end(numbers), does_not_rise) == std::end(numbers);
}

}  // namespace fiberfate
