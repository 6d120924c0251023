// Compares result folders: reads them, refuses what does not belong together, names the page.
#pragma once

#include <string>
#include <vector>

#include "results/report_document.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {

/// Makes the report of one result folder. Raises InputError where it has nothing to show.
[[nodiscard]] ReportDocument report_of(const ResultFolder& folder);

/// Makes one document of several result folders. Raises InputError where a folder is given twice or holds
/// another study than the first.
[[nodiscard]] ReportDocument compare_folders(const std::vector<std::string>& folders);

/// Where a comparison is written when nobody says: comparison.html in the folder that holds all results, or
/// else in the working directory.
[[nodiscard]] std::string comparison_path(const std::vector<std::string>& folders);

}  // namespace fiberfate
