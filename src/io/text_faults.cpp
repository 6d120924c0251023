// Looks for bytes that do not belong into a text.
#include "io/text_faults.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fiberfate {
namespace {

bool is_continuation(unsigned char byte) {
  return (byte & 0xC0) == 0x80;
}

/// How many bytes the character at the beginning has in UTF-8 (RFC 3629); 0 where it is none.
std::size_t character_size(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t size = first < 0x80                    ? 1
                           : first >= 0xC2 && first < 0xE0 ? 2
                           : first >= 0xE0 && first < 0xF0 ? 3
                           : first >= 0xF0 && first < 0xF5 ? 4
                                                           : 0;
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if (!is_continuation(byte(i))) return 0;
  if (size < 3) return size;
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool beyond = (first == 0xED && byte(1) > 0x9F) || (first == 0xF4 && byte(1) > 0x8F);
  return overlong || beyond ? 0 : size;
}

/// What is wrong with the character at the beginning of a text, and what to do; nothing where nothing
/// is.
std::pair<std::string, std::string> fault_at(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  if (first == 0)
    return {"is not a text file: it holds a zero byte",
            "give a text; one in UTF-16 must be saved as UTF-8 first"};
  if (first == '\r' && !text.starts_with("\r\n"))
    return {"a carriage return stands alone", "save the file with the line ends of Unix or Windows"};
  if ((first < 0x20 && first != '\t' && first != '\n' && first != '\r') || first == 0x7F)
    return {fmt::format("holds a control character (0x{:02X})", first), "remove it"};
  if (character_size(text) == 0) return {"the file holds bytes that are not UTF-8", "save it as UTF-8 text"};
  return {};
}

}  // namespace

std::optional<InputProblem> text_fault(std::string_view text, const std::string& name) {
  int line = 1;
  std::size_t line_begin = 0;
  for (std::size_t i = 0; i < text.size();) {
    const auto [complaint, remedy] = fault_at(text.substr(i));
    if (!complaint.empty())
      return InputProblem{name, line, static_cast<int>(i - line_begin) + 1, "", "", complaint, remedy};
    if (text[i] == '\n') {
      ++line;
      line_begin = i + 1;
    }
    i += character_size(text.substr(i));
  }
  return std::nullopt;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

std::string shortened(std::string_view text, std::size_t most) {
  constexpr std::string_view ellipsis = "...";
  if (text.size() <= most) return std::string(text);
  std::size_t end = most - ellipsis.size();
  while (end > 0 && is_continuation(static_cast<unsigned char>(text[end]))) --end;
  return std::string(text.substr(0, end)) + std::string(ellipsis);
}

}  // namespace fiberfate
