// Files that a user names, looked at before they are read.
#pragma once

#include <cstdint>
#include <string>

#include "base/error.hpp"

namespace fiberfate {

/// Bytes beyond which a text or a table is taken for a mistake.
constexpr std::uint64_t largest_input = std::uint64_t{1} << 30;

/// Why a path cannot be read as a file: "is a folder, not a file", "is
/// larger than 1 GB", "cannot be read (Permission denied)"; nothing when it can. Pipes and devices may never
/// end, so that they are not opened.
[[nodiscard]] std::string reading_fault(const std::string& path, std::uint64_t most_bytes = largest_input);

/// Raises InputError, which names the path, where a file cannot be read.
void require_readable(const std::string& path, std::uint64_t most_bytes = largest_input);

/// Reads a whole file; raises InputError where it cannot be read.
[[nodiscard]] std::string read_input_file(const std::string& path, std::uint64_t most_bytes = largest_input);

/// Gives a complaint behind its place, "lengths.csv:2:1: …", for the message of a key that names the file.
[[nodiscard]] std::string complaint_with_place(const InputProblem& problem);

}  // namespace fiberfate
