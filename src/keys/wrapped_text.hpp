// Breaks texts into lines.
#pragma once

#include <cstddef>
#include <string>

namespace fiberfate {

/// Breaks a text between words into lines of at most `width` letters that begin with `margin`; a longer word
/// has a line of its own. Every line ends with a line break.
[[nodiscard]] std::string wrapped(const std::string& text, const std::string& margin, std::size_t width);

}  // namespace fiberfate
