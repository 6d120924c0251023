// Reads plain text files of numbers in rows, such as flow histories.
#pragma once

#include <string>
#include <vector>

namespace fiberfate {

/// The numbers of one line.
struct NumberRow {
  int line = 0;
  std::vector<double> numbers;
};

/// Reads rows of `columns` finite numbers, separated by spaces, tabs and commas; or by semicolons, and then a
/// comma is a decimal comma. Empty lines and what follows a '#' are skipped, and so is a first line of words
/// (a heading). Raises InputError with all lines at fault.
[[nodiscard]] std::vector<NumberRow> read_number_file(const std::string& path, std::size_t columns);

}  // namespace fiberfate
