// What is said of a disk that does not take what is written.
#pragma once

#include <string>

namespace fiberfate {

/// Puts an error number of the operating system into words; of a disk that is full, with what to do.
[[nodiscard]] std::string reason_text(int error_number);

/// Whether the disk of a path has no room left. Libraries do not always tell.
[[nodiscard]] bool is_disk_full(const std::string& path);

}  // namespace fiberfate
