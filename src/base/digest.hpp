// A text told by a number, so that a change of it is seen.
#pragma once

#include <cstdint>
#include <string_view>

namespace fiberfate {

/// Digests text piece by piece (FNV-1a, 64 bits: Fowler, Noll and Vo): the same text gives the same number
/// however it is cut. It finds accidents, not attacks.
class Digest {
 public:
  void add(std::string_view text) {
    for (const char letter : text) value_ = (value_ ^ static_cast<unsigned char>(letter)) * prime;
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  static constexpr std::uint64_t prime = 0x100000001b3U;
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

[[nodiscard]] inline std::uint64_t digest_of(std::string_view text) {
  Digest digest;
  digest.add(text);
  return digest.value();
}

}  // namespace fiberfate
