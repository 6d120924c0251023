// The command export.
#pragma once

#include <string>

namespace fiberfate {

struct ExportOptions {
  std::string folder;
  std::string
      format;  ///< "vtp", "csv", "abaqus", "calculix"; an unknown one raises InputError with a suggestion
  std::string out;  ///< where to write; empty: folder/export_<format>
};

/// Writes a result in another format; returns the exit status.
int run_export(const ExportOptions& options);

}  // namespace fiberfate
