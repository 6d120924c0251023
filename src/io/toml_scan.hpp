// A first look at TOML texts, for what the TOML library cannot bear.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {

/// What the first look finds.
struct TomlScan {
  std::optional<InputProblem> fault;
  std::vector<std::size_t> breaks;  ///< places in long lists where a line may end
};

/// Goes through a text. A fault is where lists or tables in braces are nested, or a dotted key is long,
/// beyond what a case can mean (64): the library calls itself for each level and would exhaust the stack.
/// Likewise a table in braces that is longer than 32 kB: the library looks through the whole line at each
/// value. Lists can be broken into lines. `name` is the file in the problem.
[[nodiscard]] TomlScan scan_toml(std::string_view text, const std::string& name);

/// A text with line ends at some places; finds its bytes in the text without.
class BrokenText {
 public:
  BrokenText(std::string_view text, std::vector<std::size_t> breaks);
  [[nodiscard]] const std::string& text() const { return text_; }
  /// Where a byte stands in the text as it was given.
  [[nodiscard]] std::size_t original(std::size_t offset) const;

 private:
  std::vector<std::size_t> breaks_;  ///< by place in the given text
  std::string text_;
};

}  // namespace fiberfate
