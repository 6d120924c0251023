// Holds pairs of rods side by side, so that they can be worked on in packs.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// Packs the three numbers of an image, each in [−128, 127], into one; 0 is the cell itself.
[[nodiscard]] inline std::int32_t pack_image(const IntVec3& image) {
  const auto byte = [&](int i) { return static_cast<std::uint32_t>(image[i]) & 0xFFU; };
  return static_cast<std::int32_t>(byte(0) | byte(1) << 8 | byte(2) << 16);
}

/// Takes a packed image apart.
[[nodiscard]] inline IntVec3 unpack_image(std::int32_t packed) {
  const auto bits = static_cast<std::uint32_t>(packed);
  const auto number = [bits](int i) { return static_cast<int>(static_cast<std::int8_t>(bits >> (8 * i))); };
  return {number(0), number(1), number(2)};
}

/// Lists pairs of a rod and the image of a rod (possibly of itself): struct of arrays.
struct RodPairs {
  std::vector<Index> first;
  std::vector<Index> second;
  std::vector<std::int32_t> image;  ///< packed; second stands at x + H · image
  std::vector<float> wake;  ///< the pair cannot matter before the travels of its two rods add up to this, m

  [[nodiscard]] Index size() const { return static_cast<Index>(first.size()) - padding_; }

  /// Empties the list and keeps its memory.
  void clear() {
    for (auto* array : {&first, &second, &image}) array->clear();
    wake.clear();
    padding_ = 0;
  }
  void add(Index one, Index other, std::int32_t packed_image, float wakes) {
    first.push_back(one);
    second.push_back(other);
    image.push_back(packed_image);
    wake.push_back(wakes);
  }
  /// Adds pairs that never wake, so that packs of sixteen may be read up to the end.
  void pad() {
    for (padding_ = 0; padding_ < 16; ++padding_) add(0, 0, 0, std::numeric_limits<float>::infinity());
  }

 private:
  Index padding_ = 0;
};

}  // namespace fiberfate
