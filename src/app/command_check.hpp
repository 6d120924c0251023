// The command check.
#pragma once

#include <string>

#include "keys/case_file.hpp"

namespace fiberfate {

struct CheckOptions {
  std::string case_file;
  CaseChanges changes;
};

/// Reads and validates a case and prints it resolved, with what follows from it and what it needs; returns
/// the exit status. Raises InputError with everything that is wrong.
int run_check(const CheckOptions& options);

}  // namespace fiberfate
