// Finds an entry of a list of choices by its name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {

/// Raises InputError for a name that is none of `names`, with the nearest of them or all; `kind` is
/// "closure", say.
[[noreturn]] void refuse_name(std::string_view kind, std::string_view name,
                              const std::vector<std::string>& names);

/// Finds the entry whose member `name` is this; raises InputError as refuse_name when there is none.
template <class Entries>
[[nodiscard]] const auto& entry_named(const Entries& entries, std::string_view kind, std::string_view name) {
  std::vector<std::string> names;
  for (const auto& entry : entries) {
    if (entry.name == name) return entry;
    names.emplace_back(entry.name);
  }
  refuse_name(kind, name, names);
}

}  // namespace fiberfate
