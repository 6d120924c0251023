// Checks the values of laws' parameters.
#include "continuum/law_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace fiberfate {

void check_law_values(std::string_view law, const std::vector<LawParameter>& parameters,
                      std::span<const double> values) {
  if (values.size() != parameters.size())
    throw InputError(
        fmt::format("the law '{}' has {} parameters, not {}", law, parameters.size(), values.size()),
        "give one value for each");
  std::vector<InputProblem> problems;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const LawParameter& parameter = parameters[i];
    const auto complain = [&](std::string value, std::string complaint, std::string remedy) {
      problems.push_back(
          {"", 0, 0, parameter.name, std::move(value), std::move(complaint), std::move(remedy)});
    };
    if (std::isnan(values[i])) {
      complain("", fmt::format("not given; the law '{}' needs it", law), "give a number");
    } else if (std::isinf(values[i]) || values[i] < parameter.lower || values[i] > parameter.upper) {
      complain(fmt::format("{:g}", values[i]),
               fmt::format("outside of [{:g}, {:g}] {}, which the law '{}' takes", parameter.lower,
                           parameter.upper, parameter.unit, law),
               "choose a finite number between");
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
}

}  // namespace fiberfate
