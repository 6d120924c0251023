// What reading a case needs to know of its study.
#pragma once

#include <any>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "keys/key_table.hpp"

namespace fiberfate {

class CaseChecker;

/// The case struct of some study; only that study's functions look inside.
using CaseValues = std::any;

/// How the cases of one study are made, described and checked; all functions are pure.
struct CaseKind {
  std::string name;                                               ///< as in study = "name"
  std::string summary;                                            ///< one line
  std::function<CaseValues()> make;                               ///< a case with all defaults
  std::function<void(KeyTable&, CaseValues&)> describe;           ///< adds every key
  std::function<void(const CaseValues&, CaseChecker&)> validate;  ///< finds contradictions between keys
};

/// Makes the kind of the cases that a struct holds.
template <class Case>
[[nodiscard]] CaseKind case_kind(std::string name, std::string summary, void (*describe)(KeyTable&, Case&),
                                 void (*validate)(const Case&, CaseChecker&)) {
  return {std::move(name), std::move(summary), [] { return CaseValues(Case{}); },
          [describe](KeyTable& table, CaseValues& values) { describe(table, *std::any_cast<Case>(&values)); },
          [validate](const CaseValues& values, CaseChecker& checker) {
            validate(*std::any_cast<Case>(&values), checker);
          }};
}

/// The kinds that a case file may ask for.
using CaseKinds = std::vector<const CaseKind*>;

}  // namespace fiberfate
