// Texts without the blanks around them.
#pragma once

#include <string_view>

namespace fiberfate {

/// Leaves out spaces and tabs at both ends; of nothing else an empty part of the text is left.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return text.substr(0, 0);
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace fiberfate
