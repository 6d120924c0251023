// Lines and columns of a text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace fiberfate {

/// Where a byte of a text stands; both count from 1.
struct TextPlace {
  int line = 1;
  int column = 1;
};

/// Knows where the lines of a text begin.
class TextPlaces {
 public:
  explicit TextPlaces(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') line_begins_.push_back(i + 1);
  }
  [[nodiscard]] TextPlace at(std::size_t offset) const {
    const auto next = std::upper_bound(line_begins_.begin(), line_begins_.end(), offset);
    return {static_cast<int>(next - line_begins_.begin()), static_cast<int>(offset - *std::prev(next)) + 1};
  }
  /// The byte that stands at a place.
  [[nodiscard]] std::size_t offset_of(TextPlace place) const {
    const auto line = std::min(static_cast<std::size_t>(std::max(place.line, 1)), line_begins_.size());
    return line_begins_[line - 1] + static_cast<std::size_t>(std::max(place.column, 1) - 1);
  }

 private:
  std::vector<std::size_t> line_begins_ = {0};
};

}  // namespace fiberfate
