// Looks at files and reads them.
#include "io/input_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "io/atomic_file.hpp"

namespace fiberfate {
namespace {

std::string size_text(std::uint64_t bytes) {
  return bytes < (std::uint64_t{1} << 30) ? fmt::format("{} MB", bytes >> 20)
                                          : fmt::format("{} GB", bytes >> 30);
}

std::string system_fault() {
  return fmt::format("cannot be read ({})", std::strerror(errno));
}

}  // namespace

std::string reading_fault(const std::string& path, std::uint64_t most_bytes) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return system_fault();
  if (S_ISDIR(status.st_mode)) return "is a folder, not a file";
  if (!S_ISREG(status.st_mode)) return "is a pipe or a device, not a file";
  if (::access(path.c_str(), R_OK) != 0) return system_fault();
  if (static_cast<std::uint64_t>(status.st_size) > most_bytes)
    return fmt::format("is larger than {}", size_text(most_bytes));
  return "";
}

void require_readable(const std::string& path, std::uint64_t most_bytes) {
  const std::string fault = reading_fault(path, most_bytes);
  if (!fault.empty()) throw InputError({{path, 0, 0, "", "", fault, "check the path"}});
}

std::string read_input_file(const std::string& path, std::uint64_t most_bytes) {
  require_readable(path, most_bytes);
  try {
    return read_file(path);
  } catch (const StorageError& error) {
    throw InputError(error.what(), "check the file");
  }
}

std::string complaint_with_place(const InputProblem& problem) {
  return InputProblem{problem.file, problem.line, problem.column, "", "", problem.complaint, ""}.message();
}

}  // namespace fiberfate
