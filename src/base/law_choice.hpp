// Choices among the laws of a registry, by name.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/law_text.hpp"

namespace fiberfate {

/// Makes the error for a name that no law has: it offers the nearest name, or all of them.
[[nodiscard]] InputError unknown_law(const char* kind, std::string_view name,
                                     const std::vector<std::string>& names);

/// Lists the names of a registry's laws.
template <class Row>
[[nodiscard]] std::vector<std::string> law_names(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) names.emplace_back(row.text.name);
  return names;
}

/// Finds the row of a law; raises InputError for a name that no law has. `kind` is what the registry lists.
template <class Row>
[[nodiscard]] const Row& law_named(const std::vector<Row>& rows, std::string_view name, const char* kind) {
  const auto found = std::ranges::find_if(rows, [&](const Row& row) { return row.text.name == name; });
  if (found == rows.end()) throw unknown_law(kind, name, law_names(rows));
  return *found;
}

/// Whether a law reads a constant.
[[nodiscard]] bool reads_constant(const LawText& law, std::string_view constant);

}  // namespace fiberfate
