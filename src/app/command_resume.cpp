// Continues a run from its last checkpoint.
#include "app/command_resume.hpp"

#include "app/study_registry.hpp"

#include <fmt/format.h>

#include "keys/case_file.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {
namespace {

constexpr int stopped_by_signal = 4;

}  // namespace

int run_resume(const RunOptions& options) {
  ResultFolder folder = ResultFolder::open(options.out);
  const LoadedCase loaded = load_resolved_case(folder.resolved_case(), case_kinds());
  const StopReason reason = study_of(loaded).resume(loaded.values, options, folder);
  fmt::print("{}: result in {}\n", name(reason), folder.path());
  return reason == StopReason::signal ? stopped_by_signal : 0;
}

}  // namespace fiberfate
