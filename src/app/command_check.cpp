// Prints a case as it would run.
#include "app/command_check.hpp"

#include "app/say.hpp"
#include "app/study_registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/memory.hpp"
#include "keys/case_file.hpp"

namespace fiberfate {
namespace {

std::string duration_text(double seconds) {
  if (std::isnan(seconds)) return "unknown";
  if (seconds < 0.1) return "less than 0.1 s";
  if (seconds < 10) return fmt::format("about {:.2g} s", seconds);
  if (seconds < 120) return fmt::format("about {:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("about {:.0f} min", seconds / 60);
  if (seconds < 172800) return fmt::format("about {:.0f} h", seconds / 3600);
  if (seconds < 3.2e8) return fmt::format("about {:.0f} days", seconds / 86400);
  return fmt::format("about {:.2g} years", seconds / 3.156e7);
}

}  // namespace

int run_check(const CheckOptions& options) {
  const LoadedCase loaded = load_case(options.case_file, case_kinds(), options.changes);
  CaseEstimate estimate = study_of(loaded).estimate(loaded.values);
  estimate.facts.emplace_back("memory", memory_text(estimate.memory_bytes));
  estimate.facts.emplace_back(
      "wall time", fmt::format("{} ({})", duration_text(estimate.wall_seconds), estimate.assumption));
  std::size_t width = 0;
  for (const auto& [name, value] : estimate.facts) width = std::max(width, name.size());

  for (const std::string& warning : loaded.warnings) say(fmt::format("warning: {}\n", warning));
  if (const double free = free_memory_bytes(); estimate.memory_bytes > free)
    say(fmt::format("warning: the case takes {} of memory, and {} are free\n",
                    memory_text(estimate.memory_bytes), memory_text(free)));
  fmt::print("{}\n# What follows from it:\n", resolved_case(*loaded.kind, loaded.values));
  for (const auto& [name, value] : estimate.facts) fmt::print("#   {:<{}}  {}\n", name, width, value);
  return 0;
}

}  // namespace fiberfate
