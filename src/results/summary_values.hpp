// Every value of a summary.json by name.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "results/summary.hpp"

namespace fiberfate {

/// Lists the values of a summary file in their order; leaves out what is null or of another kind (`timings`).
/// Raises StorageError when the file is missing or not JSON.
[[nodiscard]] std::vector<std::pair<std::string, SummaryValue>> summary_values(const std::string& path);

}  // namespace fiberfate
