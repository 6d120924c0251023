// Reads plain text files of numbers in rows, such as flow histories.
#pragma once

#include <string>
#include <vector>

namespace fiberfate {

/// Reads rows of `columns` finite numbers, separated by spaces, tabs, commas or semicolons. Empty lines and
/// what follows a '#' are skipped, and so is a first line of words (a heading). Raises InputError with all
/// lines at fault.
[[nodiscard]] std::vector<std::vector<double>> read_number_file(const std::string& path, std::size_t columns);

}  // namespace fiberfate
