// Turns the syntax errors of the TOML library into messages for the user at the keyboard.
#pragma once

#include <string>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {

/// Translates the library's many-line message ("[error] … 3 | key = 19 um … ^--- expected newline") into one
/// problem with place, complaint and remedy; `lines` are the lines of the file.
[[nodiscard]] InputProblem syntax_problem(const std::string& library_message, const std::string& file,
                                          const std::vector<std::string>& lines);

}  // namespace fiberfate
