// Checks the values that a user gives for the parameters of a law.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "continuum/law_parameter.hpp"

namespace fiberfate {

/// Raises InputError, which names the law and the parameter, unless there is one value a parameter, none of
/// them NaN or infinite and each within its parameter's bounds.
void check_law_values(std::string_view law, const std::vector<LawParameter>& parameters,
                      std::span<const double> values);

/// Raises InputError for a name that is none of `names`, with the nearest of them or all; `kind` is
/// "attrition law", say.
[[noreturn]] void refuse_law_name(std::string_view kind, std::string_view name,
                                  const std::vector<std::string>& names);

}  // namespace fiberfate
