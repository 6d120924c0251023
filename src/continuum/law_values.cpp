// Checks the values of laws' parameters.
#include "continuum/law_values.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace fiberfate {

void check_law_values(std::string_view law, const std::vector<LawParameter>& parameters,
                      std::span<const double> values) {
  if (values.size() != parameters.size())
    throw InputError(
        fmt::format("the law '{}' has {} parameters, not {}", law, parameters.size(), values.size()),
        "give one value for each");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const LawParameter& parameter = parameters[i];
    if (std::isnan(values[i]))
      throw InputError(fmt::format("the law '{}' needs a value for {}", law, parameter.name), "give one");
    if (std::isinf(values[i]))
      throw InputError(fmt::format("{} of the law '{}' is infinite", parameter.name, law),
                       "give a finite number");
    if (values[i] < parameter.lower || values[i] > parameter.upper)
      throw InputError(fmt::format("{} = {:g} of the law '{}' is outside of [{:g}, {:g}] {}", parameter.name,
                                   values[i], law, parameter.lower, parameter.upper, parameter.unit),
                       "choose a value between");
  }
}

void refuse_law_name(std::string_view kind, std::string_view name, const std::vector<std::string>& names) {
  const std::string near = nearest_word(name, names);
  throw InputError(fmt::format("there is no {} '{}'", kind, name),
                   near.empty() ? fmt::format("take one of {}", fmt::join(names, ", "))
                                : fmt::format("did you mean '{}'?", near));
}

}  // namespace fiberfate
