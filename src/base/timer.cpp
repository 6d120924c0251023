// Asks the operating system for times and memory.
#include "base/timer.hpp"

#include <sys/resource.h>

namespace fiberfate {
namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

rusage resource_usage() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

}  // namespace

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double cpu_seconds() {
  const rusage usage = resource_usage();
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

std::size_t peak_memory_bytes() {
  return static_cast<std::size_t>(resource_usage().ru_maxrss) * 1024U;
}

}  // namespace fiberfate
