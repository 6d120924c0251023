// Checks the values that a user gives for the parameters of a law.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "continuum/law_parameter.hpp"

namespace fiberfate {

/// Raises InputError, with a problem for each fault whose key is the parameter, "C_B", unless there is one
/// value a parameter, none of them NaN or infinite and each within its parameter's bounds.
void check_law_values(std::string_view law, const std::vector<LawParameter>& parameters,
                      std::span<const double> values);

}  // namespace fiberfate
