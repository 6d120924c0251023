// The command resume.
#pragma once

#include "app/run_options.hpp"

namespace fiberfate {

/// Continues the run in options.out from its last checkpoint; returns the exit status.
int run_resume(const RunOptions& options);

}  // namespace fiberfate
