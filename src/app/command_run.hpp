// The command run.
#pragma once

#include "app/run_options.hpp"

namespace fiberfate {

/// Runs options.case_file into a new result folder, or a sweep into several; returns the exit status. Raises
/// InputError, SimulationFailure or StorageError, which main turns into messages and statuses.
int run_run(const RunOptions& options);

}  // namespace fiberfate
