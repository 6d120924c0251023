// Encodes binary arrays as base64 (RFC 4648), for numbers inside JSON.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace fiberfate {

/// Encodes bytes, padded with '='.
[[nodiscard]] std::string encode_base64(std::span<const std::byte> bytes);

}  // namespace fiberfate
