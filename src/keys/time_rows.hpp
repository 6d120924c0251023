// Checks tables whose rows begin with a time.
#pragma once

#include <fmt/format.h>

#include <string>

#include "keys/case_checker.hpp"

namespace fiberfate {

/// Requires that the rows of a key, each a time and what holds from then on, begin at 0 and are sorted by
/// time; reports the first row that is not so.
template <typename Rows>
void check_times_of_rows(const std::string& key, const Rows& rows, CaseChecker& checker) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 ? rows[0][0] == 0 : rows[i][0] > rows[i - 1][0]) continue;
    checker.error_in_row(key, i,
                         i == 0
                             ? std::string("the first row is not at time 0")
                             : fmt::format("the time of row {} is not later than that of row {}", i + 1, i),
                         "begin with a row at 0 s and sort the rows by time");
    return;
  }
}

}  // namespace fiberfate
