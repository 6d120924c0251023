// Runs what may crash in a process of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace fiberfate {

/// Bounds what a child process may use.
struct ChildLimits {
  double processor_seconds = 60;
  std::uint64_t memory_bytes = std::uint64_t{4} << 30;  ///< beside what this process holds already
};

/// Reports that a child process came to no end of its own; `what` says how: "it crashed (Segmentation
/// fault)".
class ChildFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Calls `work` in a child process, a copy of this one with one thread, and gives back the bytes that it
/// returns. An InputError that `work` raises is raised here; anything else that goes wrong there, a crash, a
/// call of std::terminate, too much time or memory, raises ChildFailure. Nothing else that `work` does is
/// seen here; its standard streams are closed.
[[nodiscard]] std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits);

}  // namespace fiberfate
