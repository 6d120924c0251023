// Breaks texts into lines.
#include "keys/wrapped_text.hpp"

#include <sstream>

namespace fiberfate {

std::string wrapped(const std::string& text, const std::string& margin, std::size_t width) {
  std::istringstream words(text);
  std::string lines, line = margin;
  for (std::string word; words >> word;) {
    if (line.size() > margin.size() && line.size() + 1 + word.size() > width) {
      lines += line + '\n';
      line = margin;
    }
    line += (line.size() > margin.size() ? " " : "") + word;
  }
  return lines + line + '\n';
}

}  // namespace fiberfate
