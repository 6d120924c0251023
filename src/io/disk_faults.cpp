// Puts faults of the disk into words.
#include "io/disk_faults.hpp"

#include <fmt/format.h>
#include <sys/statvfs.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>

namespace fiberfate {

std::string reason_text(int error_number) {
  const char* reason = std::strerror(error_number);
  const char* remedy = "make room there; what ended early goes on with 'fiberfate resume'";
  switch (error_number) {
    case ENOSPC:
      return fmt::format("the disk is full ({}): {}", reason, remedy);
    case EDQUOT:
      return fmt::format("your share of the disk is used up ({}): {}", reason, remedy);
    case EFBIG:
      return fmt::format("files may not grow so large here ({}): raise the limit ('ulimit -f')", reason);
    default:
      return reason;
  }
}

bool is_disk_full(const std::string& path) {
  constexpr std::uint64_t no_room = 1 << 16;  // bytes: less than any write that may have failed
  struct statvfs disk {};
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return ::statvfs(folder.empty() ? "." : folder.c_str(), &disk) == 0 && disk.f_blocks > 0 &&
         static_cast<std::uint64_t>(disk.f_bavail) * disk.f_frsize < no_room;
}

}  // namespace fiberfate
