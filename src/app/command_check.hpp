// Declares the command check.
#pragma once

#include <string>
#include <vector>

namespace fiberfate {

struct CheckOptions {
  std::string case_file;
  std::vector<std::string> overrides;  ///< "key=value"
};

/// Reads and validates a case and prints it resolved, with what follows from it and what it needs; returns
/// the exit status. Raises InputError with everything that is wrong.
int run_check(const CheckOptions& options);

}  // namespace fiberfate
