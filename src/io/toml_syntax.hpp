// Turns the syntax errors of the TOML library into messages for the user at the keyboard.
#pragma once

#include <string>

#include "base/error.hpp"
#include "io/toml_scan.hpp"

namespace fiberfate {

/// The text as the user wrote it and as the library read it.
struct TomlTexts {
  const std::string& written;
  const BrokenText& read;
};

/// Translates the library's many-line message ("[error] … 3 | key = 19 um … ^--- expected newline") into one
/// problem with place, complaint and remedy.
[[nodiscard]] InputProblem syntax_problem(const std::string& library_message, const std::string& file,
                                          const TomlTexts& texts);

}  // namespace fiberfate
