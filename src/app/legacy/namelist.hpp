// Reads Fibers.in, a Fortran namelist, into keys that know their line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace fiberfate {

/// One entry of a namelist: `key = values` or `key(index) = value`.
struct NamelistEntry {
  std::string key;                  ///< in lower case
  std::string written;              ///< the key as it stands in the file
  int index = 0;                    ///< from 1; 0 where none is given
  std::vector<std::string> values;  ///< as written
  int line = 0;
};

/// A namelist.
class LegacyNamelist {
 public:
  /// Reads `&input … /`: comments start with '!', commas are blanks, repeats "3*1.5d-3" are unfolded. Raises
  /// InputError with file and line.
  explicit LegacyNamelist(const std::string& path);

  [[nodiscard]] const std::vector<NamelistEntry>& entries() const { return entries_; }
  [[nodiscard]] const NamelistEntry* find(const std::string& key) const;
  /// Give the value of a key; empty where the key is missing. A value of another kind raises InputError.
  [[nodiscard]] std::optional<double> number(const std::string& key) const;
  [[nodiscard]] std::optional<bool> truth(const std::string& key) const;
  [[nodiscard]] std::optional<std::vector<double>> numbers(const std::string& key, std::size_t count) const;
  /// Makes a problem at a key, or at the file where the key is missing.
  [[nodiscard]] InputProblem problem(const std::string& key, const std::string& complaint,
                                     const std::string& remedy) const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  [[nodiscard]] double number_of(const NamelistEntry& entry, std::size_t place) const;
  std::string path_;
  std::vector<NamelistEntry> entries_;
};

}  // namespace fiberfate
