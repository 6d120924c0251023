// Puts the facts about a key into words.
#pragma once

#include <string>

#include "keys/key_table.hpp"

namespace fiberfate {

/// The facts about one key, each in words; empty where there is nothing to say.
struct KeyFacts {
  std::string kind;
  std::string unit;
  std::string standard;  ///< the default, or "none", or "none: required"
  std::string range;
  std::string example;
  std::string source;
};

/// The facts about a key of a table whose members are at their defaults.
[[nodiscard]] KeyFacts key_facts(const Key& key);

}  // namespace fiberfate
