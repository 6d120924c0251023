// Runs a case into a result folder.
#include "app/command_run.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/run_study.hpp"
#include "app/run_sweep.hpp"
#include "app/say.hpp"
#include "app/study_registry.hpp"
#include "keys/case_file.hpp"

namespace fiberfate {
namespace {

/// The folder of a case's result: "shear.toml" gives "results/shear"; a "case.toml" is named after its
/// folder.
std::string default_folder(const std::string& case_file) {
  const std::filesystem::path path = std::filesystem::absolute(case_file);
  const std::string stem =
      path.stem() == "case" ? path.parent_path().filename().string() : path.stem().string();
  return "results/" + stem;
}

}  // namespace

int run_run(const RunOptions& options) {
  const std::string named = options.out.empty() ? default_folder(options.case_file) : options.out;
  if (!options.sweep.empty()) return run_sweep(options, named + (options.out.empty() ? "_sweep" : ""));
  const LoadedCase loaded = load_case(options.case_file, case_kinds(), options.changes);
  for (const std::string& warning : loaded.warnings) say(fmt::format("warning: {}\n", warning));
  check_options(study_of(loaded), options.session);
  return run_anew(loaded, options, named);
}

}  // namespace fiberfate
