// Words the refusal of numbers.
#include "base/number_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {
namespace {

std::string words_for(const NumberRange& range) {
  constexpr double largest = std::numeric_limits<double>::max();
  const bool below = range.lower > -largest, above = range.upper < largest;
  if (!below && !above) return "give a finite number";
  if (below && above) return fmt::format("give a number from {:g} to {:g}", range.lower, range.upper);
  if (above) return fmt::format("give a finite number of at most {:g}", range.upper);
  return range.above_lower ? fmt::format("give a finite number above {:g}", range.lower)
                           : fmt::format("give a finite number of at least {:g}", range.lower);
}

std::string complaint_about(double value) {
  if (std::isnan(value)) return "not a number";
  return std::isinf(value) ? "not finite" : "out of range";
}

}  // namespace

void refuse_number(std::string_view path, double value, const NumberRange& range) {
  throw InputError(std::vector<InputProblem>{
      {"", 0, 0, std::string(path), fmt::format("{:g}", value), complaint_about(value), words_for(range)}});
}

void refuse_number(std::string_view path, std::size_t place, double value, const NumberRange& range) {
  refuse_number(fmt::format("{}[{}]", path, place), value, range);
}

void require_same_size(std::string_view path, std::size_t size, std::size_t expected) {
  if (size != expected)
    throw InputError(fmt::format("{} has {} values, not {}", path, size, expected), "give one for each");
}

}  // namespace fiberfate
