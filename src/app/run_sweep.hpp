// Runs a case for every combination of the values of a sweep.
#pragma once

#include "app/run_options.hpp"

namespace fiberfate {

/// Runs options.case_file once for each combination of options.sweep, each into a folder of its own below
/// `path`, and writes path/sweep.csv after every run; returns the exit status. All cases are checked before
/// the first one runs (InputError with the problems of all). A run that fails leaves an empty row, and the
/// others go on; a signal ends the sweep.
int run_sweep(const RunOptions& options, const std::string& path);

}  // namespace fiberfate
