// Continues a run from its last checkpoint.
#include "app/command_resume.hpp"

#include <utility>

#include "app/run_study.hpp"
#include "app/study_registry.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {

int run_resume(const RunOptions& options) {
  OwnedFolder folder = OwnedFolder::take(options.out);
  const LoadedCase loaded = load_resolved_case(folder.folder().resolved_case(), case_kinds());
  check_options(study_of(loaded), options.session);
  return run_study(loaded, options, std::move(folder), Begin::where_it_stopped);
}

}  // namespace fiberfate
