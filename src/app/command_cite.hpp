// The command cite.
#pragma once

#include <string>

namespace fiberfate {

struct CiteOptions {
  std::string folder = {};  ///< of the result; empty: only the program is cited
};

/// Prints what a paper says of a result: the method, its laws, the values that the case chose, and the
/// references; returns the exit status. Raises InputError where the folder holds no result.
int run_cite(const CiteOptions& options);

}  // namespace fiberfate
