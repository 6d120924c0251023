// Asks the operating system how much memory there is.
#include "base/memory.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <new>
#include <thread>

#include "base/error.hpp"

namespace fiberfate {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Reads a number of a file of the kernel; `missing` where there is none ("max").
double number_in(const std::string& path, double missing) {
  double number = 0;
  return std::ifstream(path) >> number ? number : missing;
}

/// Reads the number behind a word; 0 where there is none.
double number_after(const std::string& path, const std::string& word) {
  std::ifstream file(path);
  std::string found;
  double number = 0;
  while (file >> found)
    if (found == word && file >> number) return number;
  return 0;
}

double kilobytes_of_machine(const std::string& entry) {
  return 1024 * number_after("/proc/meminfo", entry);
}

/// What the process holds, in bytes: address space (0), data (5), as /proc/self/statm lists them.
double held(int entry) {
  std::ifstream file("/proc/self/statm");
  double pages = 0;
  for (int i = 0; i <= entry; ++i) file >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double limit_of(__rlimit_resource resource) {
  rlimit now{};
  getrlimit(resource, &now);
  return now.rlim_cur == RLIM_INFINITY ? unlimited : static_cast<double>(now.rlim_cur);
}

/// What one control group allows and what it uses without what it can give back, bytes.
struct GroupMemory {
  double limit = unlimited;
  double used = 0;
};

/// The files that tell so, in both versions of control groups.
struct GroupFiles {
  const char *root, *limit, *used, *cache;
};
constexpr GroupFiles first_version = {"/sys/fs/cgroup/memory", "memory.limit_in_bytes",
                                      "memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles second_version = {"/sys/fs/cgroup", "memory.max", "memory.current", "inactive_file"};

GroupMemory memory_of(const std::string& folder, const GroupFiles& files) {
  GroupMemory memory;
  memory.limit = number_in(folder + files.limit, unlimited);
  memory.used = number_in(folder + files.used, 0) - number_after(folder + "memory.stat", files.cache);
  return memory;
}

/// Calls visit(GroupMemory) for the control group of this process and those above it.
template <class Visit>
void visit_groups(const Visit& visit) {
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(':'), last = line.find(':', colon + 1);
    if (last == std::string::npos) continue;
    const std::string controllers = line.substr(colon + 1, last - colon - 1);
    if (!controllers.empty() && controllers != "memory") continue;
    const GroupFiles& files = controllers.empty() ? second_version : first_version;
    for (std::string group = line.substr(last + 1);; group.resize(group.rfind('/'))) {
      visit(memory_of(files.root + group + '/', files));
      if (group.empty() || group.rfind('/') == std::string::npos) break;
    }
  }
}

}  // namespace

std::uint64_t held_address_space() {
  return static_cast<std::uint64_t>(held(0));
}

double free_memory_bytes() {
  double most = kilobytes_of_machine("MemAvailable:") + kilobytes_of_machine("SwapFree:");
  if (most == 0) most = unlimited;
  visit_groups([&most](const GroupMemory& group) { most = std::min(most, group.limit - group.used); });
  most = std::min(most, limit_of(RLIMIT_AS) - held(0));
  most = std::min(most, limit_of(RLIMIT_DATA) - held(5));
  return std::max(0.0, most);
}

void bound_memory() {
  if (has_shadow_memory) return;
  double most = kilobytes_of_machine("MemTotal:") + kilobytes_of_machine("SwapTotal:");
  if (most == 0) return;
  visit_groups([&most](const GroupMemory& group) { most = std::min(most, group.limit); });
  constexpr double bytes_a_thread = 16e6;  // of stacks, which are never used whole
  most += bytes_a_thread * std::thread::hardware_concurrency();
  rlimit now{};
  getrlimit(RLIMIT_DATA, &now);
  if (most >= static_cast<double>(std::min(now.rlim_cur, now.rlim_max))) return;
  now.rlim_cur = static_cast<rlim_t>(most);
  setrlimit(RLIMIT_DATA, &now);
}

void require_room(std::size_t bytes) {
  void* mapped = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::bad_alloc();
  ::munmap(mapped, bytes);
}

std::string memory_text(double bytes) {
  return bytes < 1e9 ? fmt::format("about {:.0f} MB", bytes / 1e6)
                     : fmt::format("about {:.1f} GB", bytes / 1e9);
}

void require_memory(double bytes, const std::string& remedy) {
  const double free = free_memory_bytes();
  if (bytes > free)
    throw InputError(
        fmt::format("this takes {} of memory, and {} are free", memory_text(bytes), memory_text(free)),
        remedy);
}

}  // namespace fiberfate
