// Runs a study into a result folder, as the command line does.
#pragma once

#include <string>

#include "app/run_options.hpp"
#include "results/result_folder.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// Refuses options that the study does not act on (InputError).
void check_options(const Study& study, const SessionOptions& options);

/// Runs a case into a folder, with signals and progress, prints how it ended and returns the exit status. A
/// case that is refused late (InputError) leaves the disk as it was.
int run_study(const LoadedCase& loaded, const RunOptions& options, OwnedFolder folder, Begin begin);

/// Makes a result folder and runs a case from its beginning into it, as run_study does.
int run_anew(const LoadedCase& loaded, const RunOptions& options, const std::string& path);

}  // namespace fiberfate
