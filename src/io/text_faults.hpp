// What makes a text no text: bytes that are not UTF-8, control characters, lone carriage returns.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace fiberfate {

/// Finds the first byte of a text that is neither printable UTF-8 nor a tab, nor of a line end; `name` is the
/// file in the problem.
[[nodiscard]] std::optional<InputProblem> text_fault(std::string_view text, const std::string& name);

/// Gives the text behind the mark with which some editors begin UTF-8 files.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);

/// Cuts a text that would be too long for a message, between two characters, and ends it with "...".
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most = 60);

}  // namespace fiberfate
