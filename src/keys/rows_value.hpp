// Reads and writes keys that hold rows of quantities, in the case file itself or in a file of their own.
#pragma once

#include <string>
#include <vector>

#include "keys/key_value.hpp"

namespace fiberfate {

/// Reads rows into `rows`: a list of lists, one quantity a column (a plain list for a single column), or the
/// path of a text file (relative to `folder`) that holds them bare in SI. Tells all that is wrong; `rows`
/// changes only when nothing is.
[[nodiscard]] std::vector<Complaint> read_rows(const TomlValue& value, const std::vector<Column>& columns,
                                               const std::string& folder,
                                               std::vector<std::vector<double>>& rows);

/// Writes rows as a list of lists; nothing where there are none.
[[nodiscard]] std::string write_rows(const std::vector<std::vector<double>>& rows,
                                     const std::vector<Column>& columns, NumberStyle style);

}  // namespace fiberfate
