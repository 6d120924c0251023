// What a study computes, in memory.
#include "results/outcome.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace fiberfate {

const CsvTable& Outcome::table(const std::string& name) const {
  const auto found =
      std::find_if(tables.begin(), tables.end(), [&name](const NamedTable& one) { return one.name == name; });
  if (found == tables.end()) throw StorageError("this outcome has no table " + name);
  return found->table;
}

}  // namespace fiberfate
