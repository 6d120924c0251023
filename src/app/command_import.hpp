// The command import.
#pragma once

#include <string>

namespace fiberfate {

struct ImportOptions {
  std::string legacy_folder;  ///< holds Fibers.in, Initial_Positions.txt and, for flow case 1848,
                              ///< DynamicParameters.in
  std::string out;            ///< folder for the case; empty: named after the legacy folder
  enum class Existing { refuse, overwrite } existing = Existing::refuse;
};

/// Turns the input decks of the published program into a case file; returns the exit status.
int run_import(const ImportOptions& options);

}  // namespace fiberfate
