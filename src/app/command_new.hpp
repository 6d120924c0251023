// The command new.
#pragma once

#include <string>

namespace fiberfate {

struct NewOptions {
  std::string what;    ///< a study, or a case of the gallery ("04_couette_43wt", "couette_43wt" or "04")
  std::string folder;  ///< where to write; empty: named after `what`
  enum class Existing { refuse, overwrite } existing = Existing::refuse;
};

/// Writes an annotated case file of a study, or copies a case of the gallery; returns the exit status.
/// Raises InputError for an unknown name, and for files that exist unless they may be overwritten.
int run_new(const NewOptions& options);

}  // namespace fiberfate
