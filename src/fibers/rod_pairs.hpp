// Pairs of rods side by side, so that they can be worked on in packs.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "fibers/fiber_nodes.hpp"

namespace fiberfate {

/// Images farther than this from the cell in any direction cannot be packed.
inline constexpr int farthest_image = 511;

/// Packs the three numbers of an image, each of at most `farthest_image`, into one of ten bits each; 0 is the
/// cell itself.
[[nodiscard]] inline std::int32_t pack_image(const IntVec3& image) {
  const auto bits = [&](int i) { return static_cast<std::uint32_t>(image[i]) & 0x3FFU; };
  return static_cast<std::int32_t>(bits(0) | bits(1) << 10 | bits(2) << 20);
}

/// One number of a packed image. Always inlined, because kernels of several instruction sets call it.
[[gnu::always_inline]] static inline int image_number(std::int32_t packed, int direction) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(packed) << (22 - 10 * direction)) >> 22;
}

/// Takes a packed image apart.
[[nodiscard]] inline IntVec3 unpack_image(std::int32_t packed) {
  return {image_number(packed, 0), image_number(packed, 1), image_number(packed, 2)};
}

/// Lists pairs of a rod and the image of a rod (possibly of itself): struct of arrays.
struct RodPairs {
  std::vector<RodIndex> first;
  std::vector<RodIndex> second;
  std::vector<std::int32_t> image;  ///< packed; second stands at x + H · image
  std::vector<std::int32_t> wake;   ///< the pair cannot matter before the travels of its rods add up to this

  [[nodiscard]] Index size() const { return static_cast<Index>(first.size()) - padding_; }

  /// Empties the list and keeps its memory.
  void clear() { shrink(0); }
  void add(RodIndex one, RodIndex other, std::int32_t packed_image, std::int32_t wakes) {
    first.push_back(one);
    second.push_back(other);
    image.push_back(packed_image);
    wake.push_back(wakes);
  }
  /// Takes the padding away, so that pairs can be added.
  void unpad() { shrink(size()); }
  /// Keeps, in their order, the pairs for which `wanted(number)` holds, without padding.
  template <class Wanted>
  void keep_if(const Wanted& wanted) {
    Index kept = 0;
    for (Index i = 0; i < size(); ++i) {
      if (!wanted(i)) continue;
      first[kept] = first[i];
      second[kept] = second[i];
      image[kept] = image[i];
      wake[kept++] = wake[i];
    }
    shrink(kept);
  }
  /// Gives all rods new numbers, which keep their order.
  void renumber(const IndexedVector<RodIndex, RodIndex>& numbers) {
    for (auto* array : {&first, &second}) {
      for (RodIndex& rod : *array) rod = numbers[rod];
    }
  }
  /// Adds pairs that never wake, so that packs of sixteen may be read up to the end.
  void pad() {
    for (padding_ = 0; padding_ < 16; ++padding_) add({}, {}, 0, std::numeric_limits<std::int32_t>::max());
  }

 private:
  void shrink(Index pairs) {
    for (auto* array : {&first, &second}) array->resize(pairs);
    for (auto* array : {&image, &wake}) array->resize(pairs);
    padding_ = 0;
  }

  Index padding_ = 0;
};

}  // namespace fiberfate
